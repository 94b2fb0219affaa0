// The frustum of the frame at the playhead, with its picture on the image plane.
import {
  BufferAttribute, BufferGeometry, DoubleSide, Group, LinearFilter, Mesh, MeshBasicMaterial, SRGBColorSpace, Texture,
} from "three";
import { frustumLines } from "./frustum.js";
import { segments } from "./lines.js";

const IDENTITY = { position: [0, 0, 0], q: [0, 0, 0, 1] };

function imagePlane(corners, depth) {
  const geometry = new BufferGeometry();
  const positions = corners.flatMap((corner) => corner.clone().multiplyScalar(depth).toArray());
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute("uv", new BufferAttribute(new Float32Array([0, 1, 1, 1, 1, 0, 0, 0]), 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const texture = new Texture();
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearFilter;
  texture.generateMipmaps = false;
  const material = new MeshBasicMaterial({ map: texture, side: DoubleSide, visible: false });
  return new Mesh(geometry, material);
}

/// {object, show(pose, color, picture)}; pose null hides it. onReady is called when a picture has arrived.
export function createFrustum(corners, depth, width, onReady) {
  const lines = segments(frustumLines(IDENTITY, corners, depth), "#fff", { width });
  const plane = imagePlane(corners, depth);
  const object = new Group();
  object.add(lines, plane);
  object.visible = false;
  let wanted = null;

  function showPicture(source) {
    if (source === wanted) return;
    wanted = source;
    if (!source) {
      plane.material.visible = false;
      return;
    }
    const image = new Image();
    image.onload = () => {
      if (wanted !== source) return;
      plane.material.map.dispose();
      plane.material.map.image = image;
      plane.material.map.needsUpdate = true;
      plane.material.visible = true;
      onReady();
    };
    image.src = source;
  }

  return {
    object,
    show(pose, color, picture) {
      object.visible = Boolean(pose);
      if (!pose) return;
      object.position.fromArray(pose.position);
      object.quaternion.fromArray(pose.q);
      lines.material.color.set(color);
      showPicture(picture?.source ?? null);
    },
  };
}
