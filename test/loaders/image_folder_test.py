"""Hugging Face's imagefolder, by datasets.load_dataset; its shards by webdataset."""
import json
import os
import subprocess
import unittest

os.environ.update(HF_DATASETS_OFFLINE='1', HF_HUB_OFFLINE='1')

import cv2  # noqa: E402
import datasets  # noqa: E402
import numpy as np  # noqa: E402
import webdataset  # noqa: E402

from loader_case import LoaderCase  # noqa: E402

datasets.disable_progress_bars()

SPLITS = {'train': 'train', 'val': 'validation', 'test': 'test'}


class ImageFolderTest(LoaderCase):
    def loaded(self):
        """Yields each scene with its row."""
        for truth, folder in self.datasets('image_folder'):
            found = datasets.load_dataset(str(folder), cache_dir=str(self.scratch_folder()))
            self.assertEqual(sorted(found), sorted(SPLITS[split] for split in truth.splits))
            for split in truth.splits:
                rows = found[SPLITS[split]]
                scenes = {(scene.camera_name, scene.instant): scene
                          for scene in truth.of_split(split)}
                self.assertEqual(len(rows), len(scenes))
                for row in rows:
                    yield scenes[row['camera']['name'], row['instant']], row

    def objects(self):
        """Yields each labelled object with its scene and the entries of its lists."""
        for scene, row in self.loaded():
            lists = row['objects']
            self.assertEqual({len(each) for each in lists.values()}, {len(scene.labelled)})
            for i, each in enumerate(scene.labelled):
                yield scene, each, {key: entries[i] for key, entries in lists.items()}

    def test_images_and_masks_are_the_scenes(self):
        for scene, row in self.loaded():
            self.assert_same_pixels(np.array(row['image'])[..., ::-1], scene.image, scene.name)
            self.assert_same_pixels(np.array(row['mask']), scene.instances, scene.name)
            self.assert_same_pixels(np.array(row['depth']), scene.depth, scene.name)
            self.assertEqual((row['width'], row['height']), (scene.width, scene.height))
            self.assertEqual(row['stamp_ns'], scene.stamp_ns)

    def test_cameras_are_the_scenes(self):
        for scene, row in self.loaded():
            self.assert_close(row['camera']['K'], scene.K.ravel(), 0)
            self.assert_close(row['camera']['D'], scene.camera['D'][:8], 0)
            self.assert_close(row['camera']['X_GC'], scene.X_GC.ravel(), 1e-12)

    def test_objects_are_the_labelled_ones(self):
        for _, each, found in self.objects():
            self.assertEqual((found['categories'], found['class_names'], found['names'],
                              found['ids'], found['instances']),
                             (each.class_id, each.class_name, each.name, each.id, each.instance))

    def test_boxes_are_those_of_the_visible_pixels(self):
        for scene, each, found in self.objects():
            left, top, right, bottom = each.visible_pixel_box
            self.assertEqual(found['bbox'], [left, top, right + 1 - left, bottom + 1 - top])

    def test_measures_and_poses_are_the_scenes(self):
        for scene, each, found in self.objects():
            self.assert_close(found['X_CO'], each.X_CO.ravel(), 1e-12, scene.name)
            self.assert_close(found['cuboid'], np.ravel(each.cuboid_O), 1e-12, scene.name)
            self.assert_close([found['visibility'], found['truncation'], found['distance']],
                              [each.visibility, each.truncation,
                               np.linalg.norm(each.X_CO[:3, 3])], 1e-12, scene.name)

    def test_keypoints_are_pixels(self):
        for scene, each, found in self.objects():
            self.assertEqual(len(found['keypoints']), len(each.keypoints))
            for place, keypoint in zip(found['keypoints'], each.keypoints):
                self.assert_close(place, keypoint['pixel'] or [0, 0], 1e-9, scene.name)

    def test_a_split_packs_into_a_shard_of_samples(self):
        for truth, folder in self.datasets('image_folder'):
            for split in truth.splits:
                shard = self.scratch_folder() / 'shard.tar'
                subprocess.run(['tar', '--sort=name', '--exclude=metadata.jsonl', '-cf', shard,
                                '-C', folder / split, '.'], check=True)
                samples = {sample['__key__'].lstrip('./'): sample for sample in
                           webdataset.WebDataset(str(shard), shardshuffle=False)}
                scenes = truth.of_split(split)
                self.assertEqual(sorted(samples), sorted(scene.name for scene in scenes))
                for scene in scenes:
                    self.check_sample(scene, samples[scene.name])

    def check_sample(self, scene, sample):
        self.assertLessEqual({'png', 'mask.png', 'depth.tiff', 'json'}, set(sample))
        for key, expected in (('png', scene.image), ('mask.png', scene.instances),
                              ('depth.tiff', scene.depth)):
            pixels = cv2.imdecode(np.frombuffer(sample[key], np.uint8), cv2.IMREAD_UNCHANGED)
            self.assert_same_pixels(pixels, expected, f'{scene.name} {key}')
        names = json.loads(sample['json'])['objects']['names']
        self.assertEqual(names, [each.name for each in scene.labelled])


if __name__ == '__main__':
    unittest.main()
