"""A detector of MMDetection3D learns from a lidar's clouds: their preparation of KITTI, their dataset with its
augmentation, their PointPillars, smaller, on a CPU."""
import contextlib
import io
import unittest

import open_mmlab
from loader_case import LoaderCase

import mmdet3d.datasets  # noqa: F401  registers what is built by name below
import mmdet3d.models  # noqa: F401
import numpy as np
import torch
from mmdet3d.registry import DATASETS, MODELS
from mmengine.config import ConfigDict
from mmengine.dataset import pseudo_collate
from mmengine.optim import OptimWrapper
from mmengine.registry import DefaultScope

CLASSES = ('Pedestrian', 'Car')
RANGE = [0, -12.8, -3, 25.6, 12.8, 1]  # [m], as low and high ends of x, y, z
VOXEL = [0.2, 0.2, 4]
CELLS = 128  # RANGE / VOXEL
BATCH = 2

# The model of configs/_base_/models/pointpillars_hv_secfpn_kitti.py, with fewer layers and channels, and with the
# range and anchors of the dataset.
MODEL = {
    'type': 'VoxelNet',
    'data_preprocessor': {
        'type': 'Det3DDataPreprocessor', 'voxel': True,
        'voxel_layer': {'max_num_points': 32, 'point_cloud_range': RANGE, 'voxel_size': VOXEL,
                        'max_voxels': (16000, 40000)}},
    'voxel_encoder': {'type': 'PillarFeatureNet', 'in_channels': 4, 'feat_channels': [32], 'with_distance': False,
                      'voxel_size': VOXEL, 'point_cloud_range': RANGE},
    'middle_encoder': {'type': 'PointPillarsScatter', 'in_channels': 32, 'output_shape': [CELLS, CELLS]},
    'backbone': {'type': 'SECOND', 'in_channels': 32, 'layer_nums': [1, 2, 2], 'layer_strides': [2, 2, 2],
                 'out_channels': [32, 64, 128]},
    'neck': {'type': 'SECONDFPN', 'in_channels': [32, 64, 128], 'upsample_strides': [1, 2, 4],
             'out_channels': [32, 32, 32]},
    'bbox_head': {
        'type': 'Anchor3DHead', 'num_classes': 2, 'in_channels': 96, 'feat_channels': 96,
        'use_direction_classifier': True, 'assign_per_class': True,
        'anchor_generator': {
            'type': 'AlignedAnchor3DRangeGenerator', 'ranges': [[*RANGE[:2], -1.8, *RANGE[3:5], -1.8]] * 2,
            'sizes': [[0.5, 0.6, 1.75], [4.0, 1.7, 1.5]], 'rotations': [0, 1.57], 'reshape_out': False},
        'diff_rad_by_sin': True,
        'bbox_coder': {'type': 'DeltaXYZWLHRBBoxCoder'},
        'loss_cls': {'type': 'mmdet.FocalLoss', 'use_sigmoid': True, 'gamma': 2.0, 'alpha': 0.25,
                     'loss_weight': 1.0},
        'loss_bbox': {'type': 'mmdet.SmoothL1Loss', 'beta': 1.0 / 9.0, 'loss_weight': 2.0},
        'loss_dir': {'type': 'mmdet.CrossEntropyLoss', 'use_sigmoid': False, 'loss_weight': 0.2}},
    'train_cfg': {
        'assigner': [{'type': 'Max3DIoUAssigner', 'iou_calculator': {'type': 'mmdet3d.BboxOverlapsNearest3D'},
                      'pos_iou_thr': positive, 'neg_iou_thr': negative, 'min_pos_iou': negative,
                      'ignore_iof_thr': -1} for positive, negative in ((0.5, 0.35), (0.6, 0.45))],
        'allowed_border': 0, 'pos_weight': -1, 'debug': False},
    'test_cfg': None}
POINTS = {'type': 'LoadPointsFromFile', 'coord_type': 'LIDAR', 'load_dim': 4, 'use_dim': 4}


def prepare(folder):
    """Does the same as `tools/create_data.py kitti`."""
    converter = open_mmlab.preparation('kitti_converter')
    converter.create_kitti_info_file(str(folder), 'kitti')
    converter.create_reduced_point_cloud(str(folder), 'kitti')
    for name in ('train', 'val', 'trainval', 'test'):
        open_mmlab.preparation('update_infos_to_v2').update_pkl_infos(
            'kitti', str(folder), str(folder / f'kitti_infos_{name}.pkl'))
    open_mmlab.preparation('create_gt_database').create_groundtruth_database(
        'KittiDataset', str(folder), 'kitti', 'kitti_infos_train.pkl', relative_path=False)


def training_set(folder):
    """The training set of configs/_base_/datasets/kitti-3d-3class.py."""
    database = {'data_root': str(folder), 'info_path': str(folder / 'kitti_dbinfos_train.pkl'), 'rate': 1.0,
                'prepare': {'filter_by_difficulty': [-1], 'filter_by_min_points': {'Car': 5, 'Pedestrian': 5}},
                'classes': CLASSES, 'sample_groups': {'Car': 3, 'Pedestrian': 3}, 'points_loader': POINTS}
    pipeline = [
        POINTS,
        {'type': 'LoadAnnotations3D', 'with_bbox_3d': True, 'with_label_3d': True},
        {'type': 'ObjectSample', 'db_sampler': database},
        {'type': 'ObjectNoise', 'num_try': 100, 'translation_std': [1.0, 1.0, 0.5], 'global_rot_range': [0.0, 0.0],
         'rot_range': [-0.78539816, 0.78539816]},
        {'type': 'RandomFlip3D', 'flip_ratio_bev_horizontal': 0.5},
        {'type': 'GlobalRotScaleTrans', 'rot_range': [-0.78539816, 0.78539816], 'scale_ratio_range': [0.95, 1.05]},
        {'type': 'PointsRangeFilter', 'point_cloud_range': RANGE},
        {'type': 'ObjectRangeFilter', 'point_cloud_range': RANGE},
        {'type': 'PointShuffle'},
        {'type': 'Pack3DDetInputs', 'keys': ['points', 'gt_bboxes_3d', 'gt_labels_3d']}]
    return DATASETS.build({
        'type': 'KittiDataset', 'data_root': str(folder), 'ann_file': 'kitti_infos_train.pkl',
        'data_prefix': {'pts': 'training/velodyne_reduced'}, 'pipeline': pipeline, 'metainfo': {'classes': CLASSES},
        'modality': {'use_lidar': True, 'use_camera': False}, 'box_type_3d': 'LiDAR', 'test_mode': False})


class DetectorTrainingTest(LoaderCase):
    def train(self, scenes, model):
        """The losses of each step of an epoch, by their names."""
        self.assertGreater(len(scenes), 90)
        batches = torch.utils.data.DataLoader(scenes, batch_size=BATCH, shuffle=True, collate_fn=pseudo_collate)
        model.init_weights()
        model.train()
        optimizer = OptimWrapper(torch.optim.AdamW(model.parameters(), lr=2e-3, weight_decay=0.01))
        steps = [model.train_step(batch, optimizer) for batch in batches]
        return {name: np.array([float(step[name]) for step in steps]) for name in steps[0]}

    def test_losses_of_pointpillars_fall_in_an_epoch(self):
        torch.manual_seed(0)
        np.random.seed(0)
        (_, folder), = self.datasets('kitti_lidar', ['streets'])
        folder = self.scratch_copy(folder)
        with DefaultScope.overwrite_default_scope('mmdet3d'), contextlib.redirect_stdout(io.StringIO()):
            prepare(folder)
            losses = self.train(training_set(folder), MODELS.build(ConfigDict(MODEL)))
        for name in ('loss', 'loss_cls', 'loss_bbox'):
            fifth = len(losses[name]) // 5
            self.assertTrue(np.all(np.isfinite(losses[name])), name)
            self.assertLess(np.mean(losses[name][-fifth:]), 0.85 * np.mean(losses[name][:fifth]), name)


if __name__ == '__main__':
    unittest.main()
