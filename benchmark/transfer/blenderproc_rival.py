#!/usr/bin/env python3.11
"""Makes a dataset of a model with BlenderProc's own recipe, in a given processor time: images/train and labels/train in
the format of Ultralytics, with one class.

  blenderproc_rival.py MESH FOLDER --processor-seconds SECONDS [--seed 0] [--cameras 1] [--samples 50]

The recipe is examples/datasets/bop_challenge/main_lm_upright.py of BlenderProc: a room of five planes with a random
material, an emissive ceiling and a point light, 15 objects and 9 distractors that stand close together, cameras on a
shell around them that look at one of them, Cycles with 50 samples, and Intel's denoiser. Differences:

- Materials are Blender's procedural textures instead of photographs from ambientcg.com, and distractors are Blender's
  primitives with such materials instead of BOP models, as nothing is downloaded.
- Shading is as in the model's file, as Blender as a module lacks smoothing by angle.
- The model is scaled to the size of those that the recipe is made for, so that all distances can stay the same.
- A scene has one camera instead of 25: an arrangement costs next to nothing compared with a picture, and a network
  learns more from pictures of different arrangements.
- The lens and the image size are those of settings.py.

The time is that of the process with all its threads and children, from its start. When the time left is less than a
picture takes on average, the program ends and prints what it has made, as JSON. The interpreter needs
benchmark/speed/blenderproc_requirements.txt.
"""
import argparse
import json
import os
import pathlib
import random
import resource
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / 'speed'))
import blenderproc_rival as room  # the one in benchmark/speed, which starts BlenderProc without its own Blender
sys.path.append(str(pathlib.Path(__file__).parent))
import settings

import bpy
import cv2
import numpy as np

bproc = room.bproc
DIAMETER = 0.2  # [m] of the model, as in LineMOD
OBJECTS, DISTRACTORS, DISTRACTOR_POOL = 15, 9, 36
SHAPES = ('CUBE', 'CYLINDER', 'SPHERE', 'MONKEY')
TEXTURES = {'Noise': 'Fac', 'Voronoi': 'Distance', 'Brick': 'Fac', 'Wave': 'Fac', 'Checker': 'Fac', 'Magic': 'Fac'}
MIN_PIXELS = 50  # of an object with a label


def processor_seconds():
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


def random_material():
    """One of Blender's procedural textures in three colours, which also serves as relief."""
    material = bproc.material.create('random')
    kind = random.choice(list(TEXTURES))
    texture = material.new_node(f'ShaderNodeTex{kind}')
    texture.inputs['Scale'].default_value = np.exp(np.random.uniform(np.log(1), np.log(30)))
    material.link(material.new_node('ShaderNodeTexCoord').outputs['Object'], texture.inputs['Vector'])
    value = texture.outputs[TEXTURES[kind]]
    ramp = material.new_node('ShaderNodeValToRGB')
    ramp.color_ramp.elements.new(0.5)
    for element in ramp.color_ramp.elements:
        element.color = [*np.random.uniform(0, 0.8, 3), 1]
    material.link(value, ramp.inputs['Fac'])
    material.set_principled_shader_value('Base Color', ramp.outputs['Color'])
    bump = material.new_node('ShaderNodeBump')
    bump.inputs['Strength'].default_value = np.random.uniform(0, 0.3)
    material.link(value, bump.inputs['Height'])
    material.set_principled_shader_value('Normal', bump.outputs['Normal'])
    material.set_principled_shader_value('Roughness', np.random.uniform(0, 1))
    return material


def diameter(an_object):
    corners = an_object.get_bound_box()
    return np.linalg.norm(corners.max(axis=0) - corners.min(axis=0))


class Scene:
    """Everything in the recipe, rearranged for each scene."""

    def __init__(self, mesh):
        self._room = [bproc.object.create_primitive('PLANE', scale=[2, 2, 1], location=location, rotation=rotation)
                      for location, rotation in (([0, 0, 0], [0, 0, 0]), ([0, -2, 2], [-np.pi / 2, 0, 0]),
                                                 ([0, 2, 2], [np.pi / 2, 0, 0]), ([2, 0, 2], [0, -np.pi / 2, 0]),
                                                 ([-2, 0, 2], [0, np.pi / 2, 0]))]
        self._ceiling = bproc.object.create_primitive('PLANE', scale=[3, 3, 1], location=[0, 0, 10])
        self._glow = bproc.material.create('light_material')
        self._lamp = bproc.types.Light()
        self._lamp.set_energy(200)
        first, *others = [each for each in bproc.loader.load_obj(mesh) if each.blender_obj.type == 'MESH']
        for light in [each for each in bpy.data.objects if each.type == 'LIGHT' and each != self._lamp.blender_obj]:
            bpy.data.objects.remove(light)  # some model files contain one
        if others:
            bpy.context.view_layer.objects.active = first.blender_obj
            first.join_with_other_objects(others)
        first.set_scale(np.array(first.get_scale()) * DIAMETER / diameter(first))
        first.persist_transformation_into_mesh()
        self._objects = [first] + [first.duplicate() for _ in range(OBJECTS - 1)]
        for each in self._objects:
            for index, material in enumerate(each.get_materials()):
                each.set_material(index, material.duplicate())
        self._pool = [bproc.object.create_primitive(random.choice(SHAPES)) for _ in range(DISTRACTOR_POOL)]
        for each in [*self._room, self._ceiling, *self._pool]:
            each.set_cp('category_id', 0)
        for each in self._objects:
            each.set_cp('category_id', 1)

    def arrange(self):
        """Draws everything except the cameras at random."""
        distractors = random.sample(self._pool, DISTRACTORS)
        for each in self._pool:
            each.hide(True)
            each.set_location([0, 0, -10])
        for each in distractors:
            each.set_scale(np.random.uniform(0.03, 0.1, 3))
            each.replace_materials(random_material())
        for each in self._objects:
            for material in each.get_materials():
                material.set_principled_shader_value('Roughness', np.random.uniform(0, 1))
                material.set_principled_shader_value('Specular IOR Level', np.random.uniform(0, 1))
        self._glow.make_emissive(emission_strength=np.random.uniform(3, 6),
                                 emission_color=[*np.random.uniform(0.5, 1, 3), 1])
        self._ceiling.replace_materials(self._glow)
        self._lamp.set_color(np.random.uniform(0.5, 1, 3))
        self._lamp.set_location(bproc.sampler.shell(center=[0, 0, 0], radius_min=1, radius_max=1.5,
                                                    elevation_min=5, elevation_max=89))
        material = random_material()
        for each in self._room:
            each.replace_materials(material)
        standing = self._objects + distractors
        for each in standing:
            each.hide(False)
        bproc.object.sample_poses_on_surface(standing, self._room[0], self._above_the_floor,
                                             min_distance=0.01, max_distance=0.2)
        self._obstacles = [each for each in standing if not each.is_hidden()]

    def _above_the_floor(self, each):
        each.set_location(bproc.sampler.upper_region(self._room[:1], min_height=1, max_height=4,
                                                     face_sample_range=[0.4, 0.6]))
        each.set_rotation_euler(np.random.uniform([0, 0, 0], [0, 0, 2 * np.pi]))

    def add_cameras(self, count):
        bproc.utility.reset_keyframes()
        tree = bproc.object.create_bvh_tree_multi_objects(self._obstacles)
        seen = [each for each in self._obstacles if each in self._objects]
        found = 0
        while found < count:
            location = bproc.sampler.shell(center=[0, 0, 0], radius_min=0.35, radius_max=1.5,
                                           elevation_min=5, elevation_max=89)
            aim = bproc.object.compute_poi(random.sample(seen, min(10, len(seen))))
            rotation = bproc.camera.rotation_from_forward_vec(aim - location,
                                                              inplane_rot=np.random.uniform(-np.pi / 4, np.pi / 4))
            pose = bproc.math.build_transformation_mat(location, rotation)
            if bproc.camera.perform_obstacle_in_view_check(pose, {'min': 0.3}, tree):
                bproc.camera.add_camera_pose(pose, frame=found)
                found += 1


def boxes(instances, attributes):
    """The boxes around the visible pixels of each object, as shares of the picture, centre first."""
    height, width = instances.shape
    for each in attributes:
        rows, columns = np.nonzero(instances == each['idx'])
        if each['category_id'] == 1 and len(rows) >= MIN_PIXELS:
            left, right, top, bottom = columns.min(), columns.max() + 1, rows.min(), rows.max() + 1
            yield ((left + right) / 2 / width, (top + bottom) / 2 / height,
                   (right - left) / width, (bottom - top) / height)


def write(folder, number, colours, instances, attributes):
    cv2.imwrite(f'{folder}/images/train/{number:06}.jpg', cv2.cvtColor(colours, cv2.COLOR_RGB2BGR))
    lines = [' '.join(['0', *(f'{value:.6f}' for value in box)]) for box in boxes(instances, attributes)]
    pathlib.Path(f'{folder}/labels/train/{number:06}.txt').write_text(''.join(f'{line}\n' for line in lines), 'utf-8')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('mesh')
    parser.add_argument('folder')
    parser.add_argument('--processor-seconds', type=float, required=True)
    parser.add_argument('--seed', type=int, default=0)
    parser.add_argument('--cameras', type=int, default=1)
    parser.add_argument('--samples', type=int, default=50)
    arguments = parser.parse_args()
    random.seed(arguments.seed)
    np.random.seed(arguments.seed)
    for kind in ('images', 'labels'):
        os.makedirs(f'{arguments.folder}/{kind}/train')
    room.init()
    lens = json.loads(settings.camera())['camera_matrix']['data']
    bproc.camera.set_intrinsics_from_K_matrix(np.reshape(lens, (3, 3)), settings.WIDTH, settings.HEIGHT)
    bproc.renderer.set_max_amount_of_samples(arguments.samples)
    scene = Scene(arguments.mesh)
    # Only now, as this numbers the objects that exist.
    bproc.renderer.enable_segmentation_output(map_by=['category_id', 'instance'], default_values={'category_id': 0})
    starting = processor_seconds()
    made, cameras = 0, arguments.cameras
    while cameras > 0:
        scene.arrange()
        scene.add_cameras(cameras)
        data = bproc.renderer.render()
        for each in zip(data['colors'], data['instance_segmaps'], data['instance_attribute_maps']):
            write(arguments.folder, made, *each)
            made += 1
        now = processor_seconds()
        cameras = min(arguments.cameras, int((arguments.processor_seconds - now) / ((now - starting) / made)))
    print(json.dumps({'pictures': made, 'starting': starting, 'processor_seconds': processor_seconds(),
                      'version': bproc.__version__, 'blender': bpy.app.version_string}), flush=True)
    os._exit(0)  # Blender as a module crashes when it is unloaded


if __name__ == '__main__':
    main()
