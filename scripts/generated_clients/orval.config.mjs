// The client of orval has its server's address from its generator.
export default {
  plateau: {
    input: process.env.PLATEAU_DOCUMENT,
    output: { target: './generated/orval.ts', client: 'fetch', baseUrl: process.env.PLATEAU_URL },
  },
};
