/** The interpolations that the page compares, each with the server's name, words and a colour. */

export interface Method {
  readonly name: string;
  readonly words: string;
  readonly colour: string;
}

export const METHODS: readonly Method[] = [
  { name: "euler linear", words: "linear, Euler XYZ", colour: "#e05d5d" },
  { name: "linear", words: "linear, quaternion", colour: "#d99432" },
  { name: "slerp", words: "slerp", colour: "#a8a432" },
  { name: "squad", words: "squad", colour: "#43a866" },
  { name: "b-spline", words: "B-spline near", colour: "#35a3b5" },
  { name: "b-spline through", words: "B-spline through", colour: "#5b8def" },
  { name: "nurbs", words: "NURBS near", colour: "#b478dd" },
  { name: "nurbs through", words: "NURBS through", colour: "#d563a6" },
];
