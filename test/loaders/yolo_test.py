"""Darknet's YOLO, read as its data.c does."""
import pathlib
import unittest

from loader_case import LoaderCase, read_picture


def boxes_of(text):
    """Class and x, y, w, h of each line; the class may contain spaces here."""
    rows = [line.rsplit(' ', 4) for line in text.splitlines()]
    return [(row[0], [float(number) for number in row[1:]]) for row in rows]


class YoloTest(LoaderCase):
    def scenes(self):
        for truth, folder in self.datasets('yolo'):
            for scene in truth.scenes:
                yield scene, folder / f'{scene.name}.png'

    def test_the_list_names_every_image(self):
        for truth, folder in self.datasets('yolo'):
            lines = (folder / 'list.txt').read_text(encoding='utf-8').splitlines()
            self.assertEqual([pathlib.Path(line).resolve() for line in lines],
                             [(folder / f'{scene.name}.png').resolve() for scene in truth.scenes])

    def test_images_are_the_scenes(self):
        for scene, file in self.scenes():
            self.assert_same_pixels(read_picture(file), scene.image, scene.name)

    def test_boxes_are_the_loose_ones_cut_to_the_image(self):
        for scene, file in self.scenes():
            expected = []
            for each in scene.objects:
                if not each.in_view or each.dropped:
                    continue
                left, top = (max(edge, 0) for edge in each.loose_box[:2])
                right = min(each.loose_box[2], scene.width)
                bottom = min(each.loose_box[3], scene.height)
                if left < right and top < bottom:
                    expected.append((each.class_name, [
                        (left + right) / 2 / scene.width, (top + bottom) / 2 / scene.height,
                        (right - left) / scene.width, (bottom - top) / scene.height]))
            found = boxes_of(file.with_suffix('.txt').read_text(encoding='utf-8'))
            self.assertEqual([name for name, _ in found], [name for name, _ in expected])
            self.assert_close([box for _, box in found], [box for _, box in expected], 5.1e-6)

    def test_darknet_takes_every_line_with_a_number_for_its_class(self):
        count = 0
        for scene, file in self.scenes():
            for name, (x, y, width, height) in boxes_of(
                    file.with_suffix('.txt').read_text(encoding='utf-8')):
                # fill_truth_detection: "Wrong annotation" otherwise
                self.assertTrue(0 < x <= 1 and 0 < y <= 1 and width > 0 and height > 0, scene.name)
                count += name.isdigit()
        self.assertGreater(count, 500)


if __name__ == '__main__':
    unittest.main()
