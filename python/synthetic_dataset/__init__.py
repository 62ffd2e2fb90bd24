"""Reads datasets made by synthetic_dataset; see docs/python.md.

    from synthetic_dataset import Dataset
"""
from synthetic_dataset.dataset import Dataset
from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.scene import Scene, SceneObject

__all__ = ['Dataset', 'DatasetError', 'Scene', 'SceneObject']
