"""The scene of the benchmarks: a walled room with bumpy spheres that turn and circle, each with
5,000 triangles and a texture. All programs that draw it read the files that are written here."""

import json
import math
import os

import numpy as np
from PIL import Image

RINGS = 50  # 2 * 50 * 50 triangles
RATE = 30.0  # scenes per second of the recording
START = 1000.0  # [s]
LIGHT_DIRECTION = (0.45, 0.35, -0.82)
AMBIENT = 0.35
SUN = 0.75

# Boxes: name, size [m], centre [m], colour.
WALLS = [
    ("floor", (8.0, 8.0, 0.2), (0.0, 0.0, -0.1), (0.55, 0.53, 0.50)),
    ("north", (0.2, 8.0, 3.0), (4.1, 0.0, 1.5), (0.72, 0.70, 0.62)),
    ("east", (8.0, 0.2, 3.0), (0.0, -4.1, 1.5), (0.60, 0.68, 0.74)),
    ("west", (8.0, 0.2, 3.0), (0.0, 4.1, 1.5), (0.74, 0.62, 0.58)),
]
# The optical frame (x right, y down, z forward) in the world: its position and where it looks [m].
CAMERA = (-3.6, 0.0, 2.4)
TARGET = (0.6, 0.0, 0.5)


def camera_rotation():
    ahead = np.subtract(TARGET, CAMERA)
    ahead = ahead / np.linalg.norm(ahead)
    right = np.cross(ahead, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    return np.column_stack([right, np.cross(ahead, right), ahead])


def quaternion(rotation):
    """x, y, z, w of a rotation matrix whose trace is not close to -1."""
    w = math.sqrt(max(0.0, 1.0 + np.trace(rotation))) / 2.0
    x = (rotation[2, 1] - rotation[1, 2]) / (4.0 * w)
    y = (rotation[0, 2] - rotation[2, 0]) / (4.0 * w)
    z = (rotation[1, 0] - rotation[0, 1]) / (4.0 * w)
    return [float(value) for value in (x, y, z, w)]


def bumpy_sphere(number):
    """Vertices and texture coordinates on a grid of (RINGS + 1)^2, and triangles as indices."""
    a, b = np.meshgrid(np.linspace(0, np.pi, RINGS + 1), np.linspace(0, 2 * np.pi, RINGS + 1),
                       indexing="ij")
    r = 0.4 + 0.02 * np.sin((3 + number % 7) * b) * np.sin(4 * a)
    points = np.stack([r * np.sin(a) * np.cos(b), r * np.sin(a) * np.sin(b), r * np.cos(a)], -1)
    places = np.stack([b / (2 * np.pi), a / np.pi], -1)
    i, j = np.meshgrid(np.arange(RINGS), np.arange(RINGS), indexing="ij")
    first = (i * (RINGS + 1) + j).ravel()
    below = first + RINGS + 1
    triangles = np.concatenate([np.stack([first, below, below + 1], -1),
                                np.stack([first, below + 1, first + 1], -1)])
    return points.reshape(-1, 3), places.reshape(-1, 2), triangles


def write_model(folder, number):
    points, places, triangles = bumpy_sphere(number)
    v, u = np.mgrid[0:512, 0:512]
    channels = [(u * k + (v ^ u) + 50 * number) & 255 for k in (1, 2, 3)]
    Image.fromarray(np.stack(channels, -1).astype(np.uint8)).save(f"{folder}/skin{number}.png")
    with open(f"{folder}/skin{number}.mtl", "w") as out:
        out.write(f"newmtl skin\nKd 1 1 1\nmap_Kd skin{number}.png\n")
    with open(f"{folder}/model{number}.obj", "w") as out:
        out.write(f"mtllib skin{number}.mtl\nusemtl skin\n")
        out.writelines("v %.6f %.6f %.6f\n" % tuple(point) for point in points)
        out.writelines("vt %.6f %.6f\n" % tuple(place) for place in places)
        out.writelines("f %d/%d %d/%d %d/%d\n" % tuple(np.repeat(triangle + 1, 2))
                       for triangle in triangles)


def poses(objects, scenes):
    """For each scene and object: x, y, z [m], yaw [rad]; and the scale of all objects."""
    side = math.ceil(math.sqrt(objects))
    spacing = 4.0 / side
    scale = min(1.0, 0.8 * spacing)
    result = []
    for scene in range(scenes):
        turn = 2 * math.pi * scene / 97.0
        result.append([])
        for number in range(objects):
            phase = turn + number
            x = (number // side - (side - 1) / 2) * spacing + 0.05 * spacing * math.cos(phase) + 0.6
            y = (number % side - (side - 1) / 2) * spacing + 0.05 * spacing * math.sin(phase)
            result[-1].append((x, y, 0.45 * scale, phase % (2 * math.pi)))
    return result, scale


def write_world(file, folder, objects, scale, shadows):
    box = ("<visual name='{0}'><pose>{2} 0 0 0</pose><geometry><box><size>{1}</size></box></geometry>"
           "<material><ambient>{3} 1</ambient><diffuse>{3} 1</diffuse></material></visual>")
    text = lambda values: " ".join(str(value) for value in values)
    walls = "".join(box.format(name, text(size), text(centre), text(colour))
                    for name, size, centre, colour in WALLS)
    models = "".join(
        f"<model name='object{i}'><static>true</static><link name='body'><visual name='v'><geometry>"
        f"<mesh><uri>{folder}/model{i % 16}.obj</uri><scale>{scale} {scale} {scale}</scale></mesh>"
        f"</geometry></visual></link></model>\n" for i in range(objects))
    with open(file, "w") as out:
        out.write(f"""<sdf version='1.6'><world name='room'>
<scene><ambient>{AMBIENT} {AMBIENT} {AMBIENT} 1</ambient><background>0.7 0.7 0.7 1</background></scene>
<light name='sun' type='directional'><cast_shadows>{str(shadows).lower()}</cast_shadows>
<direction>{text(LIGHT_DIRECTION)}</direction><diffuse>{SUN} {SUN} {SUN} 1</diffuse></light>
<model name='room'><static>true</static><link name='walls'>{walls}</link></model>
{models}</world></sdf>
""")


def write_bag(folder, placed):
    import rosbag
    import rospy
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage

    with rosbag.Bag(f"{folder}/motion.bag", "w") as bag:
        for scene, of_objects in enumerate(placed):
            stamp = rospy.Time.from_sec(START + scene / RATE)
            message = TFMessage()
            for number, (x, y, z, yaw) in enumerate(of_objects):
                transform = TransformStamped()
                transform.header.stamp = stamp
                transform.header.frame_id = "map"
                transform.child_frame_id = f"object{number}/base"
                transform.transform.translation.x = x
                transform.transform.translation.y = y
                transform.transform.translation.z = z
                transform.transform.rotation.z = math.sin(yaw / 2)
                transform.transform.rotation.w = math.cos(yaw / 2)
                message.transforms.append(transform)
            bag.write("/tf", message, stamp)


def write(folder, objects, scenes, width, height):
    """Writes the room's files to a folder; scene.json is all of it, for programs without SDF."""
    os.makedirs(folder, exist_ok=True)
    for number in range(min(objects, 16)):
        write_model(folder, number)
    placed, scale = poses(objects, scenes)
    write_world(f"{folder}/room.sdf", folder, objects, scale, shadows=True)
    write_world(f"{folder}/bare_room.sdf", folder, objects, scale, shadows=False)
    write_bag(folder, placed)
    focal = 554.0 * width / 640.0
    description = {
        "width": width, "height": height, "focal": focal, "scale": scale,
        "camera": list(CAMERA), "rotation": camera_rotation().tolist(),
        "light_direction": LIGHT_DIRECTION, "ambient": AMBIENT, "sun": SUN,
        "walls": WALLS, "scenes": placed,
        "models": [f"{folder}/model{i % 16}.obj" for i in range(objects)],
        "pictures": [f"{folder}/skin{i % 16}.png" for i in range(objects)],
    }
    with open(f"{folder}/scene.json", "w") as out:
        json.dump(description, out)
    return description
