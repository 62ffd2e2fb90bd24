#!/usr/bin/env python3
"""Runs the reference data's compare.py with the settings of Gazebo's pictures.

usage: compare_with_gazebo.py REFERENCE_FOLDER OUT [NAME...] [compare.py's options]

Gazebo's pictures show no shadows, as its software OpenGL draws none, and nothing beyond 500 m, the far plane of its
camera. compare.py itself leaves both at this program's defaults.
"""
import os
import sys

FAR = 500  # [m], <clip> of look.py's camera
NO_SHADOWS = 'rendering: {shadow_distance: 0.001}\n'


def main() -> None:
    folder = os.path.join(os.path.realpath(sys.argv[1]), 'gazebo')
    sys.path.insert(0, folder)
    import compare  # from the reference data

    own_settings = compare.settings

    def settings(*arguments):
        text = own_settings(*arguments)
        assert text.count('  c0: {') == 1 and 'rendering:' not in text, text
        return text.replace('  c0: {', f'  c0: {{far: {FAR}, ') + NO_SHADOWS

    compare.settings = settings
    sys.argv = [os.path.join(folder, 'compare.py')] + sys.argv[2:]
    compare.main()


if __name__ == '__main__':
    main()
