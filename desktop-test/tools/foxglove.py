"""Messages of Foxglove's schemas as JSON, and the schemas (https://docs.foxglove.dev/docs/sdk/schemas).

Only the fields that these converters write are described; viewers know the schemas by their names.
"""
import base64
import struct

NUMBER, INTEGER, TEXT = {"type": "number"}, {"type": "integer"}, {"type": "string"}
BYTES = {"type": "string", "contentEncoding": "base64"}

# Points of a world whose y axis is down and z forward, in a frame whose z axis is up and x forward.
UPRIGHT_FROM_WORLD = (-0.5, 0.5, -0.5, 0.5)


def record(title=None, **properties):
    schema = {"type": "object", "properties": properties}
    return {"title": title, **schema} if title else schema


def array(items):
    return {"type": "array", "items": items}


TIME = record(sec=INTEGER, nsec=INTEGER)
VECTOR = record(x=NUMBER, y=NUMBER, z=NUMBER)
QUATERNION = record(x=NUMBER, y=NUMBER, z=NUMBER, w=NUMBER)
POSE = record(position=VECTOR, orientation=QUATERNION)
FIELD = record(name=TEXT, offset=INTEGER, type=INTEGER)
COLOR = record(r=NUMBER, g=NUMBER, b=NUMBER, a=NUMBER)
LINE = record(type=INTEGER, pose=POSE, thickness=NUMBER, scale_invariant={"type": "boolean"}, points=array(VECTOR),
              color=COLOR, colors=array(COLOR), indices=array(INTEGER))

SCHEMAS = {
    "foxglove.FrameTransform": record(
        "foxglove.FrameTransform", timestamp=TIME, parent_frame_id=TEXT, child_frame_id=TEXT, translation=VECTOR,
        rotation=QUATERNION),
    "foxglove.PoseInFrame": record("foxglove.PoseInFrame", timestamp=TIME, frame_id=TEXT, pose=POSE),
    "foxglove.PosesInFrame": record("foxglove.PosesInFrame", timestamp=TIME, frame_id=TEXT, poses=array(POSE)),
    "foxglove.PointCloud": record(
        "foxglove.PointCloud", timestamp=TIME, frame_id=TEXT, pose=POSE, point_stride=INTEGER, fields=array(FIELD),
        data=BYTES),
    "foxglove.SceneUpdate": record(
        "foxglove.SceneUpdate", deletions=array(record()),
        entities=array(record(timestamp=TIME, frame_id=TEXT, id=TEXT, lifetime=TIME, frame_locked={"type": "boolean"},
                              lines=array(LINE)))),
    "foxglove.CameraCalibration": record(
        "foxglove.CameraCalibration", timestamp=TIME, frame_id=TEXT, width=INTEGER, height=INTEGER,
        distortion_model=TEXT, D=array(NUMBER), K=array(NUMBER), R=array(NUMBER), P=array(NUMBER)),
    "foxglove.CompressedImage": record(
        "foxglove.CompressedImage", timestamp=TIME, frame_id=TEXT, data=BYTES, format=TEXT),
}

UINT8, INT32, FLOAT32 = 1, 5, 7  # foxglove.NumericType
LINE_STRIP = 0  # foxglove.LinePrimitive
IDENTITY = {"position": {"x": 0.0, "y": 0.0, "z": 0.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}


def time(t_ns):
    return {"sec": t_ns // 10**9, "nsec": t_ns % 10**9}


def vector(values):
    return dict(zip("xyz", values))


def pose(camera):
    return {"position": vector(camera.position), "orientation": dict(zip("xyzw", camera.q_xyzw))}


def transform(t_ns, parent, child, placed):
    """`placed` is the child's pose in the parent."""
    return {"timestamp": time(t_ns), "parent_frame_id": parent, "child_frame_id": child,
            "translation": vector(placed.position), "rotation": dict(zip("xyzw", placed.q_xyzw))}


def pose_in(frame_id, camera):
    return {"timestamp": time(camera.t_ns), "frame_id": frame_id, "pose": pose(camera)}


def poses_in(frame_id, t_ns, cameras):
    return {"timestamp": time(t_ns), "frame_id": frame_id, "poses": [pose(camera) for camera in cameras]}


def point_cloud(frame_id, t_ns, vertices):
    names = [("x", 0, FLOAT32), ("y", 4, FLOAT32), ("z", 8, FLOAT32)]
    names += [("red", 12, UINT8), ("green", 13, UINT8), ("blue", 14, UINT8), ("alpha", 15, UINT8)]
    names += [("observations", 16, INT32)]
    layout = struct.Struct("<3f4Bi")
    data = b"".join(layout.pack(*v.position, *v.rgb, 255, v.observations) for v in vertices)
    return {"timestamp": time(t_ns), "frame_id": frame_id, "pose": IDENTITY, "point_stride": layout.size,
            "fields": [{"name": name, "offset": offset, "type": kind} for name, offset, kind in names],
            "data": base64.b64encode(data).decode()}


def strip(points, colors):
    """A line strip of one colour (r g b from 0 to 1), or of one for each point."""
    rgba = [dict(zip("rgba", (*color, 1.0))) for color in colors]
    single = rgba[0] if len(rgba) == 1 else dict(zip("rgba", (0.0, 0.0, 0.0, 1.0)))
    return {"type": LINE_STRIP, "pose": IDENTITY, "thickness": 2.0, "scale_invariant": True,
            "points": [vector(p) for p in points], "color": single, "colors": rgba if len(rgba) > 1 else [],
            "indices": []}


def scene(frame_id, t_ns, name, lines):
    entity = {"timestamp": time(t_ns), "frame_id": frame_id, "id": name, "lifetime": time(0), "frame_locked": True,
              "lines": lines}
    return {"deletions": [], "entities": [entity]}


def calibration(frame_id, t_ns, camera):
    models = {"none": "", "radial_tangential": "plumb_bob", "kannala_brandt4": "kannala_brandt"}
    fx, fy, cx, cy = (camera[key] for key in ("fx", "fy", "cx", "cy"))
    coefficients = list(camera["coefficients"])
    if camera["distortion"] == "radial_tangential":
        coefficients += [0.0] * (5 - len(coefficients))
    return {"timestamp": time(t_ns), "frame_id": frame_id, "width": camera["width"], "height": camera["height"],
            "distortion_model": models[camera["distortion"]], "D": coefficients,
            "K": [fx, 0, cx, 0, fy, cy, 0, 0, 1], "R": [1, 0, 0, 0, 1, 0, 0, 0, 1],
            "P": [fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0]}


def image(frame_id, t_ns, path):
    kind = path.suffix.lower().lstrip(".").replace("jpg", "jpeg")
    return {"timestamp": time(t_ns), "frame_id": frame_id, "format": kind,
            "data": base64.b64encode(path.read_bytes()).decode()}
