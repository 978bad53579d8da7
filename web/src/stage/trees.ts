// Search trees over the triangles of a surface, for the point of a large mesh that lies under the pointer.

export { MeshBVH } from 'three-mesh-bvh';
