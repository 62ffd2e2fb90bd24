"""BOP, by the rules of bop_toolkit: inout.py, calc_gt_info.py, misc.py; scene_gt_coco.json by
pycocotools, models by plyfile.

bop_toolkit itself is not on PyPI.
"""
import contextlib
import functools
import io
import json
import unittest

import numpy as np
from plyfile import PlyData
from pycocotools.coco import COCO

from loader_case import LoaderCase, read_picture


def load_json(file):
    """Loads a file like inout.load_json with keys_to_int."""
    content = json.loads(file.read_text(encoding='utf-8'))
    return {int(key): value for key, value in content.items()}


@functools.lru_cache(maxsize=None)
def vertices_of(file):
    vertex = PlyData.read(str(file))['vertex']
    return np.stack([vertex['x'], vertex['y'], vertex['z']], 1).astype(float)


def box_of(mask):
    """The pixels' box as in misc.calc_2d_bbox: width and height are one less than their count."""
    rows, columns = np.nonzero(mask)
    return [columns.min(), rows.min(), columns.max() - columns.min(), rows.max() - rows.min()]


class BopTest(LoaderCase):
    def scenes(self):
        """Yields each scene with its folder, its number in it and the contents of its files."""
        for truth, folder in self.datasets('bop'):
            cameras = {each['name']: i for i, each in enumerate(truth.cameras)}
            for scene in truth.scenes:
                place = folder / scene.split_or_train / f'{cameras[scene.camera_name]:06}'
                yield (scene, place, scene.instant, self.files(place))

    @staticmethod
    @functools.lru_cache(maxsize=None)
    def files(place):
        return {name: load_json(place / f'scene_{name}.json')
                for name in ('camera', 'gt', 'gt_info')}

    def objects(self):
        """Yields each object with a pixel in the image: scene, folder, object, number, pose,
        measures."""
        for scene, place, number, files in self.scenes():
            objects = [each for each in scene.objects if each.silhouette_pixels_in_image]
            self.assertEqual(len(files['gt'][number]), len(objects), scene.name)
            self.assertEqual(len(files['gt_info'][number]), len(objects), scene.name)
            for i, each in enumerate(objects):
                yield (scene, place, each, f'{number:06}_{i:06}', files['gt'][number][i],
                       files['gt_info'][number][i])

    @functools.lru_cache(maxsize=None)
    def origins(self, folder):
        """X_OM of every obj_id, in millimetres."""
        info = json.loads((folder / 'dataset_info.json').read_text(encoding='utf-8'))
        return {each['obj_id']: np.array(each['model_origin']) for each in info['objects']}

    def test_every_folder_holds_the_images_of_its_files(self):
        for truth, folder in self.datasets('bop'):
            count = 0
            for place in folder.glob('*/[0-9]*'):
                files = self.files(place)
                images = {int(file.stem) for file in (place / 'rgb').iterdir()}
                for name in ('camera', 'gt', 'gt_info'):
                    self.assertEqual(set(files[name]), images)
                count += len(images)
            self.assertEqual(count, len(truth.scenes))

    def test_images_and_depth_are_the_scenes(self):
        for scene, place, number, files in self.scenes():
            self.assert_same_pixels(read_picture(place / f'rgb/{number:06}.png'), scene.image)
            scale = files['camera'][number]['depth_scale']
            depth = read_picture(place / f'depth/{number:06}.png')
            self.assertEqual(depth.dtype, np.uint16)
            expected = scene.depth * 1000.0
            expected[expected > 65535 * scale] = 0
            self.assert_close(depth * scale, expected, scale / 2 + 1e-3, scene.name)

    def test_cameras_are_the_scenes(self):
        for scene, _, number, files in self.scenes():
            camera = files['camera'][number]
            self.assert_close(camera['cam_K'], scene.K.ravel(), 1e-9)
            X_CG = np.linalg.inv(scene.X_GC)
            self.assert_close(camera['cam_R_w2c'], X_CG[:3, :3].ravel(), 1e-9)
            self.assert_close(camera['cam_t_w2c'], X_CG[:3, 3] * 1000, 1e-6)

    def test_poses_are_the_objects(self):
        for scene, place, each, _, pose, _ in self.objects():
            self.assertEqual(pose['obj_id'], each.instance)
            rotation = np.reshape(pose['cam_R_m2c'], (3, 3))
            self.assert_close(rotation, each.X_CO[:3, :3], 1e-9, scene.name)
            origin = self.origins(place.parents[1])[pose['obj_id']]
            self.assert_close(pose['cam_t_m2c'], each.to_camera([origin / 1000])[0] * 1000, 1e-6,
                              scene.name)

    def test_masks_are_the_silhouettes_and_visible_masks(self):
        for scene, place, each, name, _, _ in self.objects():
            for kind, expected in (('mask', each.silhouette), ('mask_visib', each.visible)):
                mask = read_picture(place / f'{kind}/{name}.png')
                self.assert_same_pixels(mask, np.where(expected, 255, 0), f'{scene.name} {kind}')

    def test_measures_follow_calc_gt_info(self):
        for scene, place, each, name, _, info in self.objects():
            self.assertEqual(info['px_count_all'], each.silhouette_pixels)
            self.assertEqual(info['px_count_visib'], np.count_nonzero(each.visible))
            number = name.split('_')[0]
            depth = read_picture(place / f'depth/{number}.png')
            self.assertEqual(info['px_count_valid'], np.count_nonzero((depth > 0)
                                                                     & each.silhouette))
            self.assertAlmostEqual(info['visib_fract'],
                                   info['px_count_visib'] / info['px_count_all'], delta=1e-9)
            if info['px_count_visib'] == 0:
                self.assertEqual((info['bbox_obj'], info['bbox_visib']), ([-1] * 4, [-1] * 4))
                continue
            self.assertEqual(info['bbox_visib'], box_of(each.visible), scene.name)
            if each.truncation == 0:
                self.assertEqual(info['bbox_obj'], box_of(each.silhouette), scene.name)

    def test_models_are_the_objects_in_millimetres(self):
        for truth, folder in self.datasets('bop'):
            infos = load_json(folder / 'models/models_info.json')
            for number, info in enumerate(truth.objects, 1):
                vertices = vertices_of(folder / f'models/obj_{number:06}.ply')
                expected = np.array(info['vertices']) * 1000 - self.origins(folder)[number]
                self.assert_close(vertices, expected, 1e-3, info['name'])
                self.assertAlmostEqual(infos[number]['diameter'], info['diameter'] * 1000,
                                       delta=1e-6)
                low = [infos[number][f'min_{axis}'] for axis in 'xyz']
                size = [infos[number][f'size_{axis}'] for axis in 'xyz']
                self.assert_close(low, expected.min(0), 1e-6)
                self.assert_close(size, np.ptp(expected, 0), 1e-6)
                self.assert_close(np.add(low, np.divide(size, 2)), np.zeros(3), 1e-6)

    def test_models_at_their_poses_cover_the_boxes(self):
        count = 0
        for scene, place, each, _, pose, info in self.objects():
            vertices = vertices_of(place.parents[1] / f'models/obj_{pose["obj_id"]:06}.ply')
            points = vertices @ np.reshape(pose['cam_R_m2c'], (3, 3)).T + pose['cam_t_m2c']
            if each.name == 'arm' or info['px_count_visib'] == 0 or points[:, 2].min() < 50:
                continue  # an articulated model's file does not contain the joints' positions
            count += 1
            pixels = scene.project(points)
            left, top, width, height = info['bbox_obj']
            found = [left, top, left + width, top + height]
            # The outermost pixels whose centres are covered lie within the outermost vertices.
            self.assert_close(found, [*np.ceil(pixels.min(0) - 1e-3),
                                      *np.floor(pixels.max(0) + 1e-3)], 1,
                              f'{scene.name} {each.name}')
        self.assertGreater(count, 500)

    def test_models_at_their_poses_have_the_scenes_depth(self):
        count = 0
        for scene, place, each, _, pose, _ in self.objects():
            if each.name == 'arm':
                continue
            vertices = vertices_of(place.parents[1] / f'models/obj_{pose["obj_id"]:06}.ply')
            points = vertices @ np.reshape(pose['cam_R_m2c'], (3, 3)).T + pose['cam_t_m2c']
            depths = scene.depth[each.visible] * 1000
            if depths.size:
                count += 1
                outside = ((depths < points[:, 2].min() - 0.5)
                           | (depths > points[:, 2].max() + 0.5)).mean()
                # Through a lens, a pixel on an edge has the depth of the triangle seen next to it,
                # whose plane goes on past its end.
                self.assertLessEqual(outside, 0.02 if any(scene.camera['D']) else 0,
                                     f'{scene.name} {each.name}')
        self.assertGreater(count, 500)

    def test_scene_gt_coco_has_the_visible_masks_in_amodal_boxes(self):
        for truth, folder in self.datasets('bop'):
            for place in folder.glob('*/[0-9]*'):
                with contextlib.redirect_stdout(io.StringIO()):
                    coco = COCO(str(place / 'scene_gt_coco.json'))
                self.assertEqual(len(coco.imgs), len(self.files(place)['gt']))
                self.assertTrue(all(number >= 1 for number in coco.anns))
                self.check_annotations(truth, place, coco)

    def check_annotations(self, truth, place, coco):
        for scene in truth.of_split(place.parent.name):
            if scene.camera_index != int(place.name):
                continue
            found = coco.loadAnns(coco.getAnnIds(imgIds=[scene.instant]))
            seen = [each for each in scene.objects if each.visible_pixels]
            self.assertEqual([each['category_id'] for each in found],
                             [each.instance for each in seen], scene.name)
            for each, annotation in zip(seen, found):
                self.assert_same_pixels(coco.annToMask(annotation) > 0, each.visible, scene.name)
                left, top, width, height = box_of(each.silhouette)
                self.assertEqual(annotation['bbox'], [left, top, width + 1, height + 1])
                self.assertEqual(annotation['ignore'], each.visibility < 0.1)

    def test_targets_are_what_is_visible_in_the_test_split(self):
        truth, folder = next(self.datasets('bop', ('cameras',)))
        targets = json.loads((folder / 'test_targets_bop19.json').read_text(encoding='utf-8'))
        expected = [{'scene_id': scene.camera_index, 'im_id': scene.instant,
                     'obj_id': each.instance, 'inst_count': 1}
                    for scene in truth.of_split('test') for each in scene.objects
                    if each.silhouette_pixels_in_image and each.visibility >= 0.1]
        self.assertEqual(targets, expected)


if __name__ == '__main__':
    unittest.main()
