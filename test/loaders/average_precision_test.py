"""Truth against itself, by the benchmarks' own evaluations: unless the average precision is 1, a label means
something else to the benchmark.

KITTI's is MMDetection3D's port (kitti_utils/eval.py); nuScenes' is its devkit's.
"""
import contextlib
import io
import json
import unittest

import open_mmlab
from loader_case import LoaderCase

import numpy as np
from mmdet3d.evaluation.functional.kitti_utils.eval import kitti_eval
from nuscenes.eval.common.config import config_factory
from nuscenes.eval.detection.evaluate import DetectionEval
from nuscenes.eval.detection.utils import category_to_detection_name
from nuscenes.nuscenes import NuScenes

DIFFICULTIES = ('easy', 'moderate', 'hard')
NUSCENES_CLASSES = ('car', 'pedestrian', 'traffic_cone')


def scores(count):
    """All different, so that recall grows step by step."""
    return np.random.default_rng(0).permutation(count) / count


class KittiAveragePrecisionTest(LoaderCase):
    def labels(self):
        """The labels of all scenes, as MMDetection3D reads them."""
        reader = open_mmlab.preparation('kitti_data_utils')
        (_, folder), = self.datasets('kitti_lidar', ['streets'])
        return [reader.get_label_anno(str(file)) for file in sorted((folder / 'training/label_2').iterdir())]

    def evaluated(self, truth, found):
        """The results of the evaluation, by the names of its measures."""
        with contextlib.redirect_stdout(io.StringIO()):
            return kitti_eval(truth, found, ['Car', 'Pedestrian'], eval_types=['bbox', 'bev', '3d'])[1]

    def detections(self, truth, is_kept=lambda i: True):
        """The labels with scores, as detections."""
        all_scores = scores(sum(len(each['name']) for each in truth))
        found, begin = [], 0
        for each in truth:
            count = len(each['name'])
            kept = [i for i in range(count) if is_kept(begin + i)]
            found.append({key: values[kept] for key, values in each.items()})
            found[-1]['score'] = all_scores[begin:begin + count][kept]
            begin += count
        return found

    def measures(self, of):
        return [f'KITTI/{name}_{kind}_AP{points}_{difficulty}_{strictness}' for name in ('Car', 'Pedestrian')
                for kind in of for points in (11, 40) for difficulty in DIFFICULTIES
                for strictness in ('strict', 'loose')]

    def test_truth_is_found_whole(self):
        truth = self.labels()
        found = self.evaluated(truth, self.detections(truth))
        for measure in self.measures(('2D', 'BEV', '3D')):
            self.assertAlmostEqual(found[measure], 100, places=6, msg=measure)

    def test_half_of_the_truth_is_found_by_half(self):
        """So that the test above can fail."""
        truth = self.labels()
        found = self.evaluated(truth, self.detections(truth, lambda i: i % 2 == 0))
        for measure in self.measures(('3D',)):
            self.assertLess(found[measure], 70, measure)


class NuScenesAveragePrecisionTest(LoaderCase):
    def evaluated(self, is_found):
        """The metrics of the annotations for which is_found(annotation) holds, as results."""
        (_, folder), = self.datasets('nuscenes_lidar', ['streets'])
        database = NuScenes('v1.0-trainval', str(folder), verbose=False)
        place = self.scratch_folder()
        of_sample = {each['token']: [] for each in self.samples(database)}
        for score, each in zip(scores(len(database.sample_annotation)), database.sample_annotation):
            if each['sample_token'] in of_sample and is_found(each):
                of_sample[each['sample_token']].append({
                    'sample_token': each['sample_token'], 'translation': each['translation'], 'size': each['size'],
                    'rotation': each['rotation'], 'velocity': list(database.box_velocity(each['token'])[:2]),
                    'detection_name': category_to_detection_name(each['category_name']), 'detection_score': score,
                    'attribute_name': ''})
        modalities = {f'use_{each}': each == 'lidar' for each in ('camera', 'lidar', 'radar', 'map', 'external')}
        (place / 'results.json').write_text(json.dumps({'meta': modalities, 'results': of_sample}))
        with contextlib.redirect_stderr(io.StringIO()):  # a progress bar
            evaluation = DetectionEval(database, config_factory('detection_cvpr_2019'), str(place / 'results.json'),
                                       'train', str(place), verbose=False)
        return evaluation.evaluate()[0]

    def samples(self, database):
        train = {each['token'] for each in database.scene if each['description'].startswith('train')}
        return [each for each in database.sample if each['scene_token'] in train]

    def test_truth_is_found_whole(self):
        """All that has points: the evaluation has no truth without."""
        metrics = self.evaluated(lambda each: each['num_lidar_pts'] > 0)
        for name in NUSCENES_CLASSES:
            self.assertAlmostEqual(metrics.mean_dist_aps[name], 1, msg=name)
            for metric in ('trans_err', 'scale_err', 'orient_err', 'vel_err'):
                error = metrics.get_label_tp(name, metric)
                if name != 'traffic_cone' or metric in ('trans_err', 'scale_err'):
                    self.assertAlmostEqual(error, 0, msg=f'{name} {metric}')

    def test_what_has_no_points_counts_as_wrong(self):
        """The evaluation leaves it out of the truth, not of the results."""
        metrics = self.evaluated(lambda each: True)
        self.assertLess(min(metrics.mean_dist_aps[name] for name in NUSCENES_CLASSES), 1)


if __name__ == '__main__':
    unittest.main()
