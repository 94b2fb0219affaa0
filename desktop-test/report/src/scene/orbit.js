// The eye: orbiting by mouse, touch and keys, the views of the buttons, following the camera.
import { PerspectiveCamera, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { fitView } from "./fit.js";

const KEY_ANGLE = 0.1; // rad per key press
const KEY_ZOOM = 1.15;
const FIELD_OF_VIEW = 45; // degrees
const VIEWS = {
  // Behind the cameras, above and to one side: what they saw lies in front.
  home: { side: 0.5, height: 0.62 },
  top: { side: 0.0, height: 1000.0 },
};
export function createEye(element, world, onChange) {
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, world.radius / 200, world.radius * 200);
  const controls = new OrbitControls(camera, element);
  controls.minDistance = world.radius / 20;
  controls.maxDistance = world.radius * 20;
  controls.addEventListener("change", onChange);
  let followed = null;

  function look(name) {
    const { side, height } = VIEWS[name];
    const across = new Vector3().crossVectors(world.forward, camera.up);
    const from = world.forward.clone().negate().addScaledVector(across, side).addScaledVector(camera.up, height).normalize();
    const { target, distance } = fitView(world.extent, from, camera);
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(from, distance);
    controls.update();
    onChange();
  }

  function orbit(left, up) {
    const offset = camera.position.clone().sub(controls.target);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta += left;
    spherical.phi -= up;
    camera.position.copy(controls.target).add(offset.setFromSpherical(spherical.makeSafe()));
    controls.update();
  }

  function zoom(factor) {
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    controls.update();
  }

  const keys = {
    ArrowLeft: () => orbit(-KEY_ANGLE, 0),
    ArrowRight: () => orbit(KEY_ANGLE, 0),
    ArrowUp: () => orbit(0, KEY_ANGLE),
    ArrowDown: () => orbit(0, -KEY_ANGLE),
    "+": () => zoom(1 / KEY_ZOOM),
    "=": () => zoom(1 / KEY_ZOOM),
    "-": () => zoom(KEY_ZOOM),
    0: () => look("home"),
  };
  element.addEventListener("keydown", (event) => {
    if (!(event.key in keys) || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });

  return {
    camera,
    look,
    /// Moves along with a point of the upright world, keeping the angle; null lets go.
    follow(point) {
      if (point && followed) {
        const step = point.clone().sub(followed);
        controls.target.add(step);
        camera.position.add(step);
        controls.update();
      } else if (point) {
        const step = point.clone().sub(controls.target);
        controls.target.copy(point);
        camera.position.add(step);
        controls.update();
      }
      followed = point?.clone() ?? null;
    },
  };
}
