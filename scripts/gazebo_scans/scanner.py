"""The scanners that are added to the reference worlds, for Gazebo 11 and for this program."""
import glob
import re

import numpy as np

RINGS, COLUMNS = 16, 360
AZIMUTHS, ELEVATIONS = (-3.1, 3.1), (-0.4, 0.3)  # [rad]; a whole turn would contain its first ray twice
RANGES = (0.3, 60.0)  # [m]
KINDS = ('ray', 'gpu_ray')

# The worlds, and the scanner's pose in each: x, y, z [m], roll, pitch, yaw [rad].
PLACES = {
    'pal_gazebo_worlds/pal_office': (-0.5, -0.5, 1, 0, 0, 0.3),
    'pal_gazebo_worlds/simple_office_with_people': (0, 2.5, 1, 0, 0, 0.3),
    'pal_gazebo_worlds/willow_garage': (-10, -8.5, 1, 0, 0, 0.3),
    'pal_gazebo_worlds/factory': (0, 0, 1, 0, 0, 0.3),
    'aws_small_warehouse/small_warehouse': (-0.04, 0.07, 1, 0, 0, 0.3),
    'aws_bookstore/bookstore': (-0.13, 0.12, 1, 0, 0, 0.3),
    'rotors_simulator/outdoor': (0, 0, 3, 0, 0, 0.3),
    'rotors_simulator/powerplant': (12.5, -13, 1.6, 0, 0, 0.3),
    'rotors_simulator/test_city': (7, -7, 1.6, 0, 0, 0.3),
    'pal_gazebo_worlds/home': (0, 0, 1, 0, 0, 0.3),
    'px4_sitl_gazebo/warehouse': (-1.5, -2.2, 1.6, 0, 0, 0.3),
    'pal_gazebo_worlds/hospital': (0, 0, 1, 0, 0, 0.3),
}


def world_file(worlds, name):
    repository, world = name.split('/')
    return sorted(glob.glob(f'{worlds}/{repository}/**/{world}.world', recursive=True))[0]


def sensor(kind, name, turn=0.0, tilt=0.0):
    def angles(tag, samples, limits, added):
        return (f'<{tag}><samples>{samples}</samples><resolution>1</resolution><min_angle>{limits[0] + added}</min_angle>'
                f'<max_angle>{limits[1] + added}</max_angle></{tag}>')
    return (f'<sensor name="{name}" type="{kind}"><always_on>1</always_on><update_rate>5</update_rate><ray><scan>'
            f'{angles("horizontal", COLUMNS, AZIMUTHS, turn)}{angles("vertical", RINGS, ELEVATIONS, tilt)}</scan>'
            f'<range><min>{RANGES[0]}</min><max>{RANGES[1]}</max><resolution>0.001</resolution></range></ray></sensor>')


def with_scanners(text, pose, sensors, more=''):
    """The text of a world with a model `scanner` added; nothing falls, and included models are static."""
    text = re.sub(r'<gravity>[^<]*</gravity>', '', text)
    text = re.sub(r'<include>((?:(?!</?include>|<static>).)*)</include>', r'<include><static>1</static>\1</include>', text,
                  flags=re.DOTALL)
    begin = text.index('>', text.index('<world')) + 1
    end = text.rindex('</world>')
    model = (f'<model name="scanner"><static>1</static><pose>{" ".join(map(str, pose))}</pose><link name="link">'
             f'{"".join(sensors)}</link></model>')
    return f'{text[:begin]}<gravity>0 0 0</gravity>{text[begin:end]}{more}{model}{text[end:]}'


def whole_ranges(ranges):
    """Ranges [m], rings x columns; RANGES[1] where the ray hits nothing."""
    ranges = np.asarray(ranges, float).reshape(RINGS, COLUMNS)
    return np.where(np.isfinite(ranges), ranges, RANGES[1])
