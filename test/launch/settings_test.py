#!/usr/bin/env python3
"""Settings files read as roslaunch reads them: the same text through both, value by value."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import xmlrpc.client

import roslaunch.config
import roslaunch.xmlloader
import rosunit

import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

LAUNCH_FILE = """<launch>
  <arg name="file"/>
  <node pkg="synthetic_dataset" type="generate" name="generate">
    <rosparam file="$(arg file)" command="load" subst_value="true"/>
  </node>
</launch>
"""

SCALARS = """
0 -0 +7 12 1_000 010 -017 0_ 08 0x1F -0xff 0b101 0o7 1:30 -1:30 190:20:30 0:30 1:60 1:2:3.5
1. 1.5 -1.5 +.5 .5 -.5 1.5e3 1.5e+3 1.5E-3 1e3 1e+3 1.e+2 1_0.2_5 .inf -.INF +.Inf .nan .NaN inf nan
1.0e+400 0.1 3.141592653589793 2.2250738585072014e-308 123456789.123456789 . .. ._ - -- + 1,5 1.2.3
yes Yes YES yEs y Y n N no NO on On off OFF true True TRUE tRUE false nul Null-x none None
deg(180) deg(-90.5) deg(1e1) deg(.5) rad(pi) rad(pi/2) rad(2*pi) rad(-pi/4) rad(1+2*3) rad(2**3)
rad(-2**2) rad(1/3) rad(1e-3) deg rad() rad degrees(3) deg(1)x xdeg(1) rad((1)) <<x = =x
2001-1-4 2001-12-14x 12:30:45Z a:b a::b 'x' "x" '' "" 'yes' "010" 'deg(180)' "a\\tb" "\\u00e9\\x41"
'it''s' !!str 010 !!float 3 !!float 3.5 !!int 3 !!int 0x10 !!bool yes !!str !degrees !radians
a/b /a ~a %a a#b a&b a*b a!b a@b a|b a>b a` \\ \\n [] {}
"""

FILES = {
    'nothing': '',
    'comments alone': '# nothing\n',
    'a document mark': '---\na: 1\n...\n',
    'groups and lists': 'a: {b: {c: [1, [2.5, {d: x}]]}}\ne:\n  - f: 1\n    g: 2\n  - h\n',
    'empty groups': 'a: {}\nb: {c: {}, d: 1}\ne: [{}, []]\n',
    'names with slashes': 'yolo/main_list: x\nyolo: {cut: 1}\na//b/: 1\nc: [{d/e: 1}]\n',
    'odd names': "a b: 1\n'1': 2\n'yes': 3\n\"c\\\"d\": 4\né: 5\nmax-rate: 6\n'': {}\n"
                 .replace("'': {}\n", ''),
    'the last of equal names': 'a: 1\nb: 2\na: 3\n',
    'merged groups': 'a: &a {x: 1, y: {z: 1}}\nb: &b {x: 2, w: 3}\nc: {<<: *a, x: 5}\n'
                     'd: {x: 6, <<: [*a, *b]}\ne: {<<: {<<: *b, v: 1}, w: 9}\nf: {<<: []}\n',
    'anchors': 'a: &n 010\nb: *n\nc: &l [*n, x]\nd: *l\n&k e: 1\n',
    'texts in blocks': 'a: |\n  one\n   two\n\nb: >-\n  folded\n  text\n\n  more\nc: plain\n'
                       '  goes on\nd: "quoted\n  goes on \\\n  here"\ne: |+\n  kept\n\n',
    'line ends of Windows': 'a: 1\r\nb: |\r\n  one\r\n  two\r\nc: x\r\n',
    'a byte order mark': '\ufeffa: 1\n',
    'characters of all kinds': 'a: äöü 漢字 🤖\nb: "\\U0001F916"\nc: <&>"\n',
    'angles in lists': 'a: [deg(90), rad(pi/4), !degrees 45, !radians (1+1)*pi/3]\n',
    'tags': 'a: !!str 1\nb: !!map {c: !!seq [1]}\ne: !!float 7\nf: !!int "8"\n',
    'the environment': 'a: $(env USED)\nb: "$(env USED)/x"\nc: $(optenv USED no)\n'
                       'd: $(optenv NOT_USED  two   words)\ne: [$(optenv NOT_USED)]\n',
    'types that follow': 'a: $(env NUMBER)\nb: "$(env NUMBER)"\n',
    'substitutes in comments': 'a: 1 # $(env USED)\n',
    'packages': 'a: "$(find roscpp)"\nb: $(find roscpp)/x.y\nc: $(find roscpp)\n'
                'd: $(find roscpp) x\ne: [$(find roscpp)/a,$(find roscpp)/b, "$(find roscpp)"]\n'
                'f: \'$(find roscpp)\\a\'\n',
    'packages from the environment': 'a: $(env PACKAGE)/x\n',
    'what is no substitution': 'a: $5 (net)\nb: $()\nc: $$(env USED)\nd: ($(env USED))\ne: $(env\n',
    'the global robot list': '/robot_list: [a, b]\n',
}

# What roslaunch, or the parameter server's protocol, refuses.
REFUSED_BY_BOTH = {
    'null': 'a: ~\n', 'an empty value': 'a:\nb: 1\n', 'null in a list': 'a: [1, ~]\n',
    'a number as a name': '1: 2\n', 'a truth as a name': 'yes: 2\n',
    'a number as a name in a list': 'a: [{1: 2}]\n', 'a date': 'a: 2001-01-01\n',
    'a set': 'a: !!set {x, y}\n', 'an unknown tag': 'a: !mine 3\n', 'two documents': 'a: 1\n---\nb: 2\n',
    'a list': '[1]\n', 'a text': 'text\n', 'a wrong number': 'a: !!int x\n',
    'a wrong angle': 'a: !degrees x\n', 'a wrong expression': 'a: rad(2 pi)\n',
    'an anchor of nobody': 'a: *b\n', 'no YAML': 'a: [1\nb: }\n', 'a value with a colon': 'a: b: c\n',
    'a name and a group': 'a: 1\na/b: 2\n', 'a merged number': 'a: {<<: 3}\n',
    'an argument': 'a: $(arg nowhere)\n', 'an expression': 'a: $(eval 1 + 1)\n',
    'an unknown word': 'a: $(findd roscpp)\n', 'no package': 'a: $(find no_such_package)\n',
    'no variable': 'a: $(env NOT_USED)\n', 'too many words': 'a: $(env A B)\n',
    'a nested one': 'a: $(find $(env USED))\n', 'a missing parenthesis': 'a: $(env A\nb: $(env B)\n',
    'a wrong one in a comment': '# $(nonsense)\na: 1\n', 'a tab in it': 'a: $(env\tUSED)\n',
    'no word': 'a: $( )\n', 'an open quote': 'a: "x\n', 'another': "a: 'x",
}

# What roslaunch accepts, but the node could not use, or not in the same way each time.
REFUSED_BY_US = {
    'a time': 'a: 2001-12-14t21:59:43.10-05:00\n', 'binary data': 'a: !!binary aGVsbG8=\n',
    'other global names': '/a: 1\n', 'names of other nodes': '~a: 1\n',
    'a name given twice in two ways': 'y/z: 1\ny: {z: 2}\n', 'random names': 'a: $(anon x)\n',
}


class Refused(Exception):
    pass


def plain(value):
    """Both readers' values in one form: floats by their bits, so that nan is equal to itself."""
    if isinstance(value, float):
        return {'float': float.hex(value)}
    if isinstance(value, list):
        return [plain(entry) for entry in value]
    if isinstance(value, dict):
        return {name: plain(entry) for name, entry in value.items()}
    return value


def read_by_roslaunch(launch_file, file):
    """The tree that is on the parameter server once roslaunch has loaded the file."""
    config = roslaunch.config.ROSLaunchConfig()
    try:
        roslaunch.xmlloader.XmlLoader().load(str(launch_file), config, argv=[f'file:={file}'],
                                             verbose=False)
        xmlrpc.client.dumps((([parameter.value for parameter in config.params.values()]),))
    except Exception as error:  # whatever it refuses
        raise Refused(error) from error
    if config.config_errors:
        raise Refused(config.config_errors)
    tree = {}
    for name, parameter in config.params.items():
        group = tree
        path = name.replace('/generate/', '', 1).strip('/').split('/')
        for step in path[:-1]:
            group = group.setdefault(step, {})
        group[path[-1]] = plain(parameter.value)
    return tree


class SettingsFile(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.launch_file = cls.scratch / 'test.launch'
        cls.launch_file.write_text(LAUNCH_FILE, encoding='utf-8')
        os.environ.update(USED='in use', NUMBER='010', PACKAGE='$(find roscpp)')
        os.environ.pop('NOT_USED', None)

    def read_by_us(self, files):
        done = subprocess.run([ros_programs.path_of_test_program('print_settings'), *map(str, files)],
                              stdout=subprocess.PIPE, universal_newlines=True, encoding='utf-8',
                              timeout=60, check=True)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), len(files))
        return [self.with_python_floats(json.loads(line)) for line in lines]

    def with_python_floats(self, tree):
        """C and Python write the same number differently in hexadecimal."""
        if isinstance(tree, list):
            return [self.with_python_floats(entry) for entry in tree]
        if isinstance(tree, dict):
            if list(tree) == ['float']:
                return plain(float.fromhex(tree['float']))
            return {name: self.with_python_floats(entry) for name, entry in tree.items()}
        return tree

    def write(self, texts):
        files = []
        for i, text in enumerate(texts):
            files.append(self.scratch / f'{i}.yaml')
            files[-1].write_bytes(text.encode('utf-8'))
        return files

    def compare(self, texts):
        files = self.write(texts.values())
        for name, file, ours in zip(texts, files, self.read_by_us(files)):
            with self.subTest(name=name):
                self.assertEqual(ours, read_by_roslaunch(self.launch_file, file))

    def test_scalars_are_those_of_roslaunch(self):
        """But what it stumbles over, such as `=`, may be a text here, or is refused here too."""
        texts = [f'a: {scalar}\n' for scalar in SCALARS.split()]
        files = self.write(texts)
        compared = 0
        for text, file, ours in zip(texts, files, self.read_by_us(files)):
            try:
                theirs = read_by_roslaunch(self.launch_file, file)
            except Refused:
                continue
            compared += 1
            with self.subTest(text=text):
                self.assertEqual(ours, theirs)
        self.assertGreater(compared, 0.8 * len(texts))

    def test_files_are_those_of_roslaunch(self):
        self.compare(FILES)

    def test_shipped_files_are_those_of_roslaunch(self):
        """But for those that include others, of which roslaunch knows nothing."""
        os.environ.setdefault('HOME', '/nowhere')
        texts = {file.name: file.read_text(encoding='utf-8')
                 for file in sorted((REPOSITORY / 'config').glob('*.yaml'))}
        whole = {name: text for name, text in texts.items()
                 if not re.search('^include:', text, re.MULTILINE)}
        self.assertGreater(len(whole), 2)
        self.compare(whole)

    def test_what_roslaunch_refuses_is_refused_with_a_place(self):
        files = self.write(REFUSED_BY_BOTH.values())
        for name, file, ours in zip(REFUSED_BY_BOTH, files, self.read_by_us(files)):
            with self.subTest(name=name):
                with self.assertRaises(Refused):
                    read_by_roslaunch(self.launch_file, file)
                self.assertIn(f'{file}: ', ours.get('error', f'read as {ours}'))

    def test_what_cannot_be_used_is_refused(self):
        files = self.write(REFUSED_BY_US.values())
        for name, file, ours in zip(REFUSED_BY_US, files, self.read_by_us(files)):
            with self.subTest(name=name):
                self.assertIn(f'{file}: ', ours.get('error', f'read as {ours}'))

    def test_dirname_is_the_folder_of_the_settings(self):
        folder = self.scratch / 'elsewhere'
        folder.mkdir()
        file = folder / 'x.yaml'
        file.write_text('a: $(dirname)/b\n', encoding='utf-8')
        self.assertEqual(self.read_by_us([file]), [{'a': f'{folder}/b'}])


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'settings', '__main__')
