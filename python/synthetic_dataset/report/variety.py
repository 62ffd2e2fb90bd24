"""The variety without which a network learns a dataset by heart. The program `check` measures the same."""
ONE_LOOK = 0.1  # up to this much detail a ground counts as plain: a plain one has 3 %, one with things on it 25 %


class Variety:
    """Other measures that were tried do not rank datasets as networks trained on them do: docs/report.md."""

    def __init__(self, dataset, brightness):
        self.detail = brightness.detail
        self.looks = _looks(dataset)

    @property
    def is_plain(self):
        """Whether each class has one look, on a plain ground."""
        return (self.detail is not None and self.detail < ONE_LOOK
                and all(count == 1 for count in self.looks.values()))


def _looks(dataset):
    """The number of looks (models and their variants) of each class."""
    drawn, settings, looks = {}, dataset.settings, {}
    for name, value in dataset.manifest.rows("SELECT DISTINCT name, value FROM draw WHERE name LIKE 'objects/%'"):
        drawn.setdefault(name, set()).add(value)
    for each in dataset.objects:
        models = drawn.get(f'objects/{each.name}/model', {settings.get(f'{each.name}/model', each.name)})
        variants = drawn.get(f'objects/{each.name}/variant', {0})
        looks.setdefault(dataset.classes[each.class_id], set()).update(
            (model, variant) for model in models for variant in variants)
    return {name: len(of_class) for name, of_class in looks.items()}
