import eslint from "@eslint/js";
import tseslint from "typescript-eslint";

/** Each exception has its reason. */
const EXCEPTIONS = {
  // `noUncheckedIndexedAccess` makes every element of an array possibly undefined: `!` says that an index is in range.
  "@typescript-eslint/no-non-null-assertion": "off",
  // Listeners are written `() => act()`, and early ends of functions without a result `return act()`.
  "@typescript-eslint/no-confusing-void-expression": [
    "error",
    { ignoreArrowShorthand: true, ignoreVoidReturningFunctions: true },
  ],
  // Numbers are written as they are.
  "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
};

export default tseslint.config(
  { ignores: ["src/net/types/api.generated.ts"] },
  eslint.configs.recommended,
  tseslint.configs.strictTypeChecked,
  {
    languageOptions: { parserOptions: { projectService: true } },
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: EXCEPTIONS,
  },
);
