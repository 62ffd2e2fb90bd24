"""Helpers that the tests of all loaders share."""
import functools
import os
import pathlib
import re
import shutil
import tempfile
import unittest

import cv2
import numpy as np

from truth import Truth, read_picture  # noqa: F401

DATASETS = ('hard', 'lens', 'empty', 'many', 'cameras')


@functools.lru_cache(maxsize=None)
def truth_of(name):
    return Truth(root() / name / 'truth')


def root():
    """The folder that make_loader_datasets wrote."""
    return pathlib.Path(os.environ['SYNTHETIC_DATASET_LOADER_DATASETS'])


def named_folder(parent, name):
    """The folder of an object: its name, or a changed one if some letters are not safe in paths."""
    if (parent / name).is_dir():
        return parent / name
    safe = re.sub(r'[^\w.-]', '_', name)
    return parent / name if safe == name else next(parent.glob(f'{safe}_*'))


class LoaderCase(unittest.TestCase):
    """Compares what one format's loader returns with the truth, dataset by dataset."""

    dataset = ''  # the current one, for messages

    def datasets(self, writer, names=DATASETS):
        """Yields each dataset's truth and the folder of a writer."""
        for name in names:
            self.dataset = name
            yield truth_of(name), root() / name / writer

    def _formatMessage(self, msg, standardMsg):
        return f'{self.dataset}: {super()._formatMessage(msg, standardMsg)}'

    def scratch_folder(self):
        """A folder for files that loaders write beside what they read; removed after the test."""
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        return folder

    def scratch_copy(self, folder):
        return pathlib.Path(shutil.copytree(folder, self.scratch_folder() / folder.name))

    def assert_same_pixels(self, found, expected, what=''):
        found, expected = np.asarray(found), np.asarray(expected)
        self.assertEqual(found.shape, expected.shape, what)
        different = np.count_nonzero(found != expected)
        self.assertEqual(different, 0, f'{what}: {different} pixels differ')

    def assert_mask_of_one_ring(self, found, expected, what=''):
        """A ring around all parts of a mask bridges the gaps between them, a pixel wide."""
        parts, _ = cv2.connectedComponents(expected.astype(np.uint8))
        if parts <= 2:  # one of them is the background
            self.assert_same_pixels(found, expected, what)
            return
        self.assertFalse(np.any(expected & ~found), what)
        bridges = (found & ~expected).astype(np.uint8)
        self.assertFalse(cv2.erode(bridges, np.ones((2, 2), np.uint8), borderValue=0).any(), what)

    def assert_close(self, found, expected, tolerance, what=''):
        found, expected = np.asarray(found, float), np.asarray(expected, float)
        self.assertEqual(found.shape, expected.shape, what)
        if found.size:
            self.assertLessEqual(np.abs(found - expected).max(), tolerance, what)
