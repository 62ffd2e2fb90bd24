"""Reads datasets that synthetic_dataset has made: docs/python.md.

    from synthetic_dataset import Dataset
"""
from synthetic_dataset.dataset import Dataset
from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.scene import Scene, SceneObject

__all__ = ['Dataset', 'DatasetError', 'Scene', 'SceneObject']
