"""A dataset made by synthetic_dataset."""
import collections
import json
import os


from synthetic_dataset.manifest import DatasetError, Manifest
from synthetic_dataset.scene import Scene, SceneObject

Writer = collections.namedtuple('Writer', 'index name type folder')
ObjectDescription = collections.namedtuple('ObjectDescription',
                                           'index name id class_id class_name')

IS_THERE = "state IN ('written', 'complete')"  # of a scene: all its files are there


class Dataset:
    """A sequence of scenes.

        dataset = Dataset('datasets/example')
        for scene in dataset.split('train'):
            for each in scene.objects:
                print(scene.index, each.name, each.visible_box)

    The manifest is read scene by scene, so large datasets need little memory.
    """

    def __init__(self, folder):
        """@throws DatasetError if there is no dataset, or its manifest cannot be read"""
        self.manifest = Manifest(folder)
        self.folder = self.manifest.folder
        self._scenes = [index for index, in self.manifest.rows(
            f'SELECT "index" FROM scene WHERE {IS_THERE} ORDER BY "index"')]
        self.writers = [
            Writer(index, name, kind, os.path.normpath(self.folder / folder))
            for index, name, kind, folder in self.manifest.rows(
                'SELECT "index", name, type, output_folder FROM writer ORDER BY "index"')]
        self.classes = dict(self.manifest.rows('SELECT id, name FROM class ORDER BY id'))
        self.cameras = [name for name, in self.manifest.rows(
            'SELECT name FROM camera ORDER BY "index"')]
        self.objects = [ObjectDescription(index, name, number, class_id, self.classes[class_id])
                        for index, name, number, class_id in self.manifest.rows(
                            'SELECT "index", name, id, class FROM object ORDER BY "index"')]

    @property
    def is_complete(self):
        """Whether the run has finished."""
        return self.manifest.run.get('state') == 'complete'

    @property
    def splits(self):
        """The names of the splits; [''] if there are none."""
        order = {'train': 0, 'val': 1, 'test': 2}
        names = [name for name, in self.manifest.rows(
            f'SELECT DISTINCT split FROM scene WHERE {IS_THERE}')]
        return sorted(names, key=lambda name: (order.get(name, 3), name))

    @property
    def settings(self):
        """The settings that were used, by full name: {'camera/far': 100.0, ...}"""
        return {name: json.loads(value) for name, value in self.manifest.rows(
            'SELECT name, value FROM setting ORDER BY name')}

    def __len__(self):
        return len(self._scenes)

    def __getitem__(self, position):
        """The scene at a position, which equals its index if the dataset is complete."""
        if isinstance(position, slice):
            return [self.scene(index) for index in self._scenes[position]]
        return self.scene(self._scenes[position])

    def __iter__(self):
        return (self.scene(index) for index in self._scenes)

    def scene(self, index):
        """The scene with an index of the manifest."""
        found = self.manifest.columns('scene', f'"index" = ? AND {IS_THERE}', (int(index),))
        if not len(found['index']):
            raise DatasetError(f"'{self.folder}': has no scene {index}; found {len(self)} scenes"
                               + (f', {self._scenes[0]} to {self._scenes[-1]}' if self else ''))
        return Scene(self, {name: column[0] for name, column in found.items()})

    def split(self, name):
        """A list of the scenes of a split."""
        if name not in self.splits:
            raise DatasetError(f"'{self.folder}': has no split '{name}'; found "
                               + ', '.join(f"'{each}'" for each in self.splits))
        return [self.scene(index) for index, in self.manifest.rows(
            f'SELECT "index" FROM scene WHERE split = ? AND {IS_THERE} ORDER BY "index"', (name,))]

    def table(self, name):
        """A table of the manifest as {column: numpy array}; null becomes NaN among numbers."""
        return self.manifest.columns(name)

    def frame(self, name):
        """A table of the manifest as a pandas DataFrame; pandas has to be installed."""
        import pandas  # nothing else in this module needs it
        return pandas.DataFrame(self.table(name))

    # Queries for Scene.

    def objects_of(self, scene):
        found = self.manifest.columns('scene_object', 'scene = ?', (scene.index,))
        return [SceneObject(scene, {name: column[row] for name, column in found.items()},
                            self.objects[int(index)])
                for row, index in enumerate(found['object'])]

    def alignment_of(self, scene):
        found = self._rows_of('scene_alignment', 'alignment', scene)
        return found[0][0] if found else None

    def alignments_of(self, scene):
        return dict(self._rows_of('object_alignment', 'object, alignment', scene))

    def cover_of(self, scene):
        found = self._rows_of('scene_cover', 'unmeasured, covered', scene)
        return found[0] if found else (None, None)

    def covers_of(self, scene):
        return {index: shares for index, *shares in
                self._rows_of('object_cover', 'object, unmeasured, covered', scene)}

    def _rows_of(self, table, columns, scene):
        """A scene's rows of a table that manifests before version 6 do not have."""
        if table not in self.manifest.tables():
            return []
        return self.manifest.rows(f'SELECT {columns} FROM {table} WHERE scene = ?', (scene.index,))

    def files_of(self, scene):
        found = []
        for path, writer in self.manifest.rows(
                'SELECT path, writer FROM file WHERE scene = ? ORDER BY writer, path',
                (scene.index,)):
            file = self.folder / path
            of = self.writers[writer]
            found.append((of, os.path.relpath(file, of.folder), file))
        return found

    def __repr__(self):
        return f"<Dataset '{self.folder}': {len(self)} scenes>"
