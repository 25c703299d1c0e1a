// A mesh of a layer: its place in the order of drawing is the layer's, and it is not seen before there is something to show.
import { Mesh, type BufferGeometry, type ShaderMaterial } from "three";

export function layerMesh<M extends ShaderMaterial>(geometry: BufferGeometry, material: M, order: number): Mesh<BufferGeometry, M> {
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false; // its bounds change with each message
  mesh.renderOrder = order;
  mesh.visible = false;
  return mesh;
}
