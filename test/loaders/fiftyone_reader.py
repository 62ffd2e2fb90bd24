"""Prints what FiftyOne's importers read from a dataset, as JSON: runs in FiftyOne's environment.

    fiftyone_reader.py FOLDER

FOLDER is one dataset of make_loader_datasets. The output is {format: {image's name: [[label,
[left, top, width, height of the image's size], mask's pixels or None]]}}.
"""
import json
import pathlib
import sys

from fiftyone.utils.coco import COCODetectionDatasetImporter
from fiftyone.utils.kitti import KITTIDetectionDatasetImporter
from fiftyone.utils.voc import VOCDetectionDatasetImporter
from fiftyone.utils.yolo import YOLOv4DatasetImporter, YOLOv5DatasetImporter


def importers(folder):
    yield 'coco', COCODetectionDatasetImporter(
        data_path=str(folder / 'coco/images'), label_types=['segmentations'],
        labels_path=str(folder / 'coco/annotations/instances_train.json'))
    yield 'kitti', KITTIDetectionDatasetImporter(
        data_path=str(folder / 'kitti/training/image_2'),
        labels_path=str(folder / 'kitti/training/label_2'))
    yield 'pascal_voc', VOCDetectionDatasetImporter(
        data_path=str(folder / 'pascal_voc/JPEGImages'),
        labels_path=str(folder / 'pascal_voc/Annotations'))
    yield 'ultralytics_detect', YOLOv5DatasetImporter(str(folder / 'ultralytics_detect'),
                                                      yaml_path='dataset.yaml', split='train')
    yield 'yolo_numbers', YOLOv4DatasetImporter(str(folder / 'yolo_numbers'),
                                                images_path='train.txt', objects_path='obj.names')


def labels_of(sample):
    """A sample is a path, the image's metadata, and labels: of one kind, or several kinds by name."""
    labels = sample[2]
    if isinstance(labels, dict):
        labels = next(iter(labels.values()), None)
    return [[each.label, each.bounding_box, None if each.mask is None else int(each.mask.sum())]
            for each in (labels.detections if labels else [])]


def main():
    read = {}
    for name, importer in importers(pathlib.Path(sys.argv[1])):
        with importer:
            read[name] = {pathlib.Path(sample[0]).stem: labels_of(sample) for sample in importer}
    print(json.dumps(read))


if __name__ == '__main__':
    main()
