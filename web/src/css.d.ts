/** A style sheet as text, imported with the attribute `type: 'text'`. */
declare module '*.css' {
  const text: string;
  export default text;
}
