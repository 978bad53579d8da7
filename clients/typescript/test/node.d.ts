// The one function of Node.js that the README uses; @types/node would change the types of a browser's globals.
declare module 'node:fs/promises' {
  export function writeFile(path: string, data: Uint8Array): Promise<void>;
}
