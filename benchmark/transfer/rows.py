"""The table's rows: one for each way to make the pictures.

A row starts from the settings of `start`: those of a first user (`plain`), or the preset (`transfer`). `over` overrides
them: groups are merged, everything else is replaced. `motions` keeps only these of the preset's motions. `scenes` is a
number of pictures for this row.
"""
import collections

Row = collections.namedtuple('Row', 'name what start over motions scenes', defaults=({}, None, None))

PRESETS = '$(find synthetic_dataset)/config'
SUN = '$(find synthetic_dataset)/worlds/sun.sdf'
TURN = 3.14159

# Where a first user's objects are, and where the camera sees them from.
PLAIN = {
    'world': {'file': '$(find synthetic_dataset)/worlds/ground.sdf'},
    'placement': {'mode': 'drop', 'orientation': 'upright', 'volume': {'min': [-2, -2, 0.1], 'max': [2, 2, 0.5]}},
    'camera': {'sample': {'look_at': 'any', 'distance': {'uniform': [1.5, 8]}, 'elevation': {'uniform': [0.05, 0.7]},
                          'aim_offset': {'normal': [0, 0.3]}}},
}
TRANSFER = {'randomize': {'preset': 'transfer', 'variety': 'same_class'}}

DISTRACTORS = {'count': {'uniform': [0, 8]}, 'pool': 60, 'mode': 'stand', 'size': {'log_uniform': [0.1, 1.0]},
               'textures': 'natural', 'volume': {'min': [-4, -4, 0], 'max': [4, 4, 2]}}
LIGHTS = {'every': {'intensity': {'log_uniform': [0.4, 1.6]}, 'elevation': {'uniform': [0.2, 1.5]},
                    'azimuth': {'uniform': [-TURN, TURN]}}}
SENSOR = {'exposure': {'normal': [0, 0.4], 'min': -1, 'max': 0.8}, 'blur': {'uniform': [0, 1.2]},
          'noise_stddev': {'uniform': [0, 0.03]}}
PASTED = {'mode': 'volume', 'orientation': 'upright', 'volume': {'min': [-2, -2, 0], 'max': [2, 2, 0.5]}}
BACKGROUND = {'pictures': 'natural', 'brightness': {'uniform': [0.6, 1.2]}}
CAMERA = {'sample': {'unit': 'sizes', 'distance': {'log_uniform': [1.1, 18]}, 'elevation': {'uniform': [0, 0.8]},
                     'aim_offset': {'normal': [0, 0.12]}, 'roll': {'normal': [0, 0.08]}}}
PLAIN_CAMERA = {'sample': {**PLAIN['camera']['sample'], 'unit': 'metres', 'roll': 0}}


def randomize(**entries):
    return {'randomize': entries}


ROWS = [
    Row('plain', "a first user's: the model on a plain ground", 'plain'),
    Row('default', 'the same with config/randomize_default.yaml', 'plain',
        {'include': f'{PRESETS}/randomize_default.yaml'}),
    Row('transfer', 'the preset, with variety: same_class', 'transfer'),

    Row('without_room', 'the preset, on backgrounds alone', 'transfer', motions=('pasted', 'fallen')),
    Row('without_pasted', 'the preset, on grounds, in rows and in rooms alone', 'transfer', motions=('open_ground', 'row', 'room')),
    Row('without_background', 'the preset, with a colour instead of pictures behind', 'transfer',
        randomize(background={'present': 0})),
    Row('without_distractors', 'the preset, nothing but the objects', 'transfer', randomize(distractors={'count': 0})),
    Row('without_weather', 'the preset in clear air', 'transfer', randomize(weather={'present': 0, 'rain': 0})),
    Row('without_sensor', 'the preset with a perfect sensor', 'transfer',
        randomize(sensor={'exposure': 0, 'blur': 0, 'noise_stddev': 0})),
    Row('without_light', 'the preset, with the same light always', 'transfer',
        randomize(lights={'every': {'present': 1, 'intensity': 1, 'colour': 1, 'elevation': 0.9, 'azimuth': 0.6}},
                  ambient=0.5)),
    Row('full_light', 'the preset with rendering/light: full', 'transfer', {'rendering': {'light': 'full'}}),
    Row('without_variety', 'the preset, with the model as it is', 'transfer', randomize(variety='none')),
    Row('same_object', 'the preset, with variety: same_object', 'transfer', randomize(variety='same_object')),
    Row('without_camera', "the preset with the first user's camera", 'transfer',
        {'camera': PLAIN_CAMERA, **randomize(sensor={'field_of_view': 1.0472})}),
    Row('without_empty', 'the preset, with every object in every picture', 'transfer',
        randomize(objects={'every': {'present': 1}})),

    Row('plain_room', 'plain, in a room with walls', 'plain',
        {'world': {'file': SUN}, **randomize(room={'size': [11, 11, 4.5], 'tile': 3},
                                             materials={'room': {'textures': 'natural'}})}),
    Row('plain_background', 'plain, on backgrounds instead of the ground', 'plain',
        {'world': {'file': SUN}, 'placement': PASTED, **randomize(background=BACKGROUND)}),
    Row('plain_distractors', 'plain, with distractors', 'plain', randomize(distractors=DISTRACTORS)),
    Row('plain_weather', 'plain, with fog and rain', 'plain',
        randomize(weather={'present': 0.15, 'visibility': {'log_uniform': [40, 400]}, 'rain': {'log_uniform': [1, 20]}})),
    Row('plain_sensor', 'plain, with exposure, blur and noise', 'plain', randomize(sensor=SENSOR)),
    Row('plain_light', 'plain, with light from everywhere', 'plain',
        randomize(lights=LIGHTS, ambient={'uniform': [0.25, 0.8]})),
    Row('plain_full_light', 'plain, with rendering/light: full', 'plain', {'rendering': {'light': 'full'}}),
    Row('plain_variety', 'plain, with variety: same_class', 'plain', randomize(variety='same_class')),
    Row('plain_camera', "plain, with the preset's camera", 'plain',
        {'camera': CAMERA, **randomize(sensor={'field_of_view': {'uniform': [0.5, 1.3]}})}),

    Row('transfer_300', 'the preset, 300 pictures', 'transfer', scenes=300),
    Row('transfer_1000', 'the preset, 1,000 pictures', 'transfer', scenes=1000),
    Row('transfer_3000', 'the preset, 3,000 pictures', 'transfer', scenes=3000),
]
