// The page's own sentences for the objectives of the service, which the form shows.

/** Sentences of the objectives, by kind and name. */
export const OBJECTIVES: Record<string, Record<string, string>> = {
  minimal_surface: {
    minimal_area: 'The film with the least area on its fixed boundary, as a soap film has.',
    minimal_dirichlet_energy: 'The film that stretches the initial mesh the least. It is the step that the method of Pinkall and Polthier repeats.',
    minimal_mean_curvature: 'The film whose squared mean curvatures have the least sum.',
  },
  ruled_surface: {
    minimal_area: 'The strip with the least area.',
    minimal_twist: 'The strip whose normals differ the least between the two ends of each bridge.',
    maximal_convexity: 'The strip with the most bridges that are locally convex.',
    minimal_bending_energy: 'The strip that takes the least energy to bend from a flat sheet.',
    minimal_mean_curvature_variation: 'The strip whose mean curvature changes the least from bridge to bridge.',
    minimal_normal_variation: 'The strip whose normals differ the least from the given ones.',
  },
  uniform_mesh: {
    fewest_nodes: 'The lattice with the fewest nodes, of members between one and two edge lengths.',
    most_equal_edges: 'The lattice with the most members of exactly the edge length; all others are at most twice as long.',
  },
  tensile_structure: { equilibrium: 'The shape in which all forces balance.' },
  cable_net: { nearest_to_targets: 'The net in equilibrium whose forces and lengths are nearest to their targets.' },
};
