"""Keeps the measurements in a file that is complete at any time."""
import json
import os


class Results:
    """The results in a file. Each new result is written before the next one is started."""

    def __init__(self, file):
        self._file = file
        self._all = {'datasets': {}, 'trainings': []}
        if os.path.exists(file):
            with open(file, encoding='utf-8') as opened:
                self._all = json.load(opened)

    def dataset(self, row):
        """{'digest': ..., 'pictures': ..., 'milliseconds': a picture} of a row's dataset, or None."""
        return self._all['datasets'].get(row)

    def keep_dataset(self, row, **facts):
        self._all['datasets'][row] = facts
        self._write()

    def training(self, row, part, seed, full, train):
        """AP50 of one training on the row's current dataset, or None."""
        dataset = self.dataset(row)
        for each in self._all['trainings'] if dataset else []:
            if each['key'] == [row, dataset['digest'], part, seed, full, train]:
                return each['ap50']
        return None

    def keep_training(self, row, part, seed, full, train, ap50, seconds):
        key = [row, self.dataset(row)['digest'], part, seed, full, train]
        self._all['trainings'].append({'key': key, 'ap50': ap50, 'seconds': seconds})
        self._write()

    def trainings(self, row, part, full, train):
        """{seed: AP50} for the row's current dataset."""
        dataset = self.dataset(row)
        return {} if dataset is None else {
            each['key'][3]: each['ap50'] for each in self._all['trainings']
            if each['key'][:3] == [row, dataset['digest'], part] and each['key'][4:] == [full, train]}

    def _write(self):
        temporary = f'{self._file}.tmp'
        with open(temporary, 'w', encoding='utf-8') as out:
            json.dump(self._all, out, indent=1)
        os.replace(temporary, self._file)
