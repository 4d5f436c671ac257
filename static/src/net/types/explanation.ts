/** Explanations: why, whynot, and the plan of a travel, under the page's names. */

export type {
  ExplainedView as Explained,
  MovedView as Moved,
  PlanView as Plan,
  RemedyView as Remedy,
  WhyNotView as WhyNot,
  WhyView as Why,
} from "./api.generated";
