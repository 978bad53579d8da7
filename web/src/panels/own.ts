// An example of the studio's own: a gridshell that opens without a warning. The surface is curved in one direction, so
// all members keep their range of lengths. Members of the roofs in the papers leave that range.

import type { ExampleSummary } from 'plateau-client';
import type { Request } from '../model/request';

export const OWN: (ExampleSummary & { request: Request })[] = [{
  name: 'vault-equal-members', kind: 'uniform_mesh', title: 'A cylindrical vault (NURBS) with as many equal members as possible',
  request: {
    domain: {
      nurbs: {
        degrees: [2, 1], knots: [[0, 0, 0, 1, 1, 1], [0, 0, 1, 1]], weights: [[1, 1], [0.7648421872844885, 0.7648421872844885], [1, 1]],
        control_points: [
          [[-12.884353745, 0, 3.296843746], [-12.884353745, 40, 3.296843746]], [[0, 0, 14.149185195], [0, 40, 14.149185195]], [[12.884353745, 0, 3.296843746], [12.884353745, 40, 3.296843746]],
        ],
      },
    },
    edge_length: 2, objective: 'most_equal_edges',
  },
}];
