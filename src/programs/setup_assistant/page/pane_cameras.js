import {cameraPath, formOf, framePath, orbitOfSettings, poseOn, roundedPose, shownPose, wayOf} from './camera_pose.js';
import {distribution} from './distribution.js';
import {h} from './dom.js';
import {choiceField, flowField, more, numberField, problemList, section, segments, switchField, textField, vectorField} from './fields.js';
import {map} from './figure_map.js';
import {fileField} from './file_fields.js';
import {renaming} from './name_field.js';
import {fileName, fixed} from './numbers.js';
import {freeName} from './paths.js';
import {matrixOfRpy, opticalOfBody, quaternionOfMatrix} from './pose_math.js';
import {problemsAt} from './problems.js';
import {frames, recording, waysOfObjects} from './recording.js';
import {renameCamera, whyNotCamera} from './rename.js';
import {scene} from './scene_loader.js';
import {answer, change, effective, objectNames, set} from './store.js';
import {cameraNames, currentCamera, show} from './view_state.js';

export const camerasPane = {
  id: 'cameras',
  title: 'Cameras',
  text:
      'What the lens is, and where it stands. A camera that is fixed or on an object is moved by dragging the picture.',
  paths: () => [['camera'], ['cameras'], ['camera_frame_id'], ['twin']],
  summary: () =>
      (effective(['cameras']) === undefined ?
           fileName(
               effective(['camera', 'info_file']) ?? effective(['camera', 'info_topic']) ??
               effective(['camera', 'sensor'])) :
           cameraNames().join(', ')),
  draw,
};

function draw() {
  const path = cameraPath();
  return [
    tabs(),
    h('div', {key: path.join('/')},
      path[0] === 'cameras' ? renaming('camera-name', path[1], {
        whyNot: whyNotCamera,
        rename: (wanted) => renameCamera(path[1], wanted).then(() => show({camera: wanted})),
      }) :
                              null,
      section('Lens', lens(path)), section('Where it is', place(path)), section('From above', fromAbove()),
      more(
          'Range of sight, rectified pictures',
          ['near', 'far', 'rectified', 'stereo_frame'].map((each) => [...path, each]),
          h('div', {class: 'pair'}, numberField([...path, 'near'], {label: 'Nearest', step: 0.01}),
            numberField([...path, 'far'], {label: 'Farthest', step: 10})),
          switchField([...path, 'rectified'], {label: 'Rectified pictures'}),
          choiceField([...path, 'stereo_frame'], null, {label: 'Frame of a second stereo camera'})),
      effects(path), depthNoise(path), twin(path)),
  ];
}

function tabs() {
  const names = cameraNames();
  return h(
      'div', {class: 'tabs', role: 'group', 'aria-label': 'Cameras'},
      names.map(
          (name) =>
              h('button', {
                key: name,
                type: 'button',
                class: 'tab',
                'aria-pressed': String(name === currentCamera()),
                onclick: () => show({camera: name}),
              },
                name)),
      h('button', {key: ' add', type: 'button', class: 'tab add', onclick: addCamera}, '+ Add'),
      names.length > 1 ? h('button', {key: ' remove', type: 'button', class: 'tab add', onclick: removeCamera},
                           `Remove ${currentCamera()}`) :
                         null);
}

// The first of several cameras is the one that was the only one before.
function addCamera() {
  const name = freeName('camera', cameraNames());
  if (effective(['cameras']) !== undefined) {
    const {[currentCamera()]: like = {}} = effective(['cameras']);
    change([[['cameras', name], like]]);
  } else {
    const {...first} = effective(['camera']) ?? {};
    const frame = effective(['camera_frame_id']);
    if (frame !== undefined && first.frame_id === undefined) first.frame_id = frame;
    change([
      [['cameras'], {camera: first, camera_2: {...first}}], [['camera'], undefined], [['camera_frame_id'], undefined]
    ]);
  }
  show({camera: effective(['cameras']) === undefined ? 'camera_2' : name});
}

function removeCamera() {
  set(['cameras', currentCamera()], undefined);
}

const LENSES = [['info_file', 'Calibration file'], ['info_topic', 'Recorded topic'], ['sensor', 'Sensor of the world']];

function lens(path) {
  const kind = LENSES.map(([each]) => each).find((each) => effective([...path, each]) !== undefined) ?? 'info_file';
  const topics = (recording()?.cameras ?? []).map((each) => each.topic);
  const sensors = (answer('api/world').value?.sensors ?? []).map((each) => each.name);
  const start = {
    info_file: '',
    info_topic: topics[0] ?? '/camera/camera_info',
    sensor: sensors[0] ?? 'model::link::sensor'
  };
  const choose = (wanted) => change([
    ...LENSES.filter(([each]) => each !== wanted && effective([...path, each]) !== undefined)
        .map(([each]) => [[...path, each], undefined]),
    [[...path, wanted], start[wanted]],
  ]);
  return [
    choice('lens', 'Comes from', LENSES, kind, choose),
    kind === 'info_file' ?
        [
          fileField([...path, 'info_file'], 'calibration', {
            label: 'Calibration',
            hint: 'camera_info YAML, ost.txt, a CameraInfo as text, Kalibr, camodocal or OpenCV.'
          }),
        ] :
        null,
    kind === 'info_topic' ? textField([...path, 'info_topic'], {label: 'Topic', suggestions: topics}) : null,
    kind === 'sensor' ? textField([...path, 'sensor'], {label: 'Sensor', suggestions: sensors}) : null,
    h('p', {class: 'facts'},
      scene.value && scene.value.camera.name === currentCamera() ? lensFacts(scene.value.camera) : ''),
  ];
}

function lensFacts({width, height, intrinsics}) {
  const focal = intrinsics?.[0];
  const angle = focal ?
      `, ${Math.round(2 * Math.atan(width / 2 / focal) * 180 / Math.PI)}\u00b0 wide without its distortion` :
      '';
  return `${width} \u00d7 ${height} px${angle}.`;
}

// A choice between settings rather than of a setting's value.
function choice(id, label, pairs, value, choose) {
  return h(
      'div', {class: 'field', key: id, role: 'group', 'aria-labelledby': `${id}-label`},
      h('div', {class: 'field-head'}, h('span', {class: 'field-label', id: `${id}-label`}, label)),
      segments(id, pairs, value, choose));
}

const WAYS = [
  ['frame', 'From TF'], ['pose', 'Fixed'], ['mounted_on', 'On an object'], ['sample', 'Random'], ['sensor', 'Sensor']
];

function place(path) {
  const way = wayOf(path);
  return [
    choice('way', 'Its pose', WAYS, way, (wanted) => changeWay(path, wanted)),
    way === 'frame' ? followed(path) : null,
    way === 'mounted_on' ? choiceField([...path, 'mounted_on'], objectNames(), {label: 'Object'}) : null,
    way === 'pose' || way === 'mounted_on' ? pose(path) : null,
    way === 'sample' ? sample(path) : null,
    way === 'sensor' ? h('p', {class: 'empty'}, 'It is where the world has the sensor, and moves with its link.') :
                       null,
  ];
}

function changeWay(path, wanted) {
  const changes = ['sample', 'mounted_on', 'pose']
                      .filter((each) => each !== wanted && effective([...path, each]) !== undefined)
                      .map((each) => [[...path, each], undefined]);
  if (wanted === 'pose') {  // keeps the view that is shown
    const here = poseOn(path);
    changes.push(
        [[...path, 'pose'], here ? roundedPose(here) : {position: [-3, 0, 2], look_at: objectNames()[0] ?? [0, 0, 0]}]);
  }
  if (wanted === 'mounted_on') {
    changes.push(
        [[...path, 'mounted_on'], objectNames()[0] ?? ''],
        [[...path, 'pose'], {position: [0.3, 0, 0.6], rpy: [0, 0.2, 0]}]);
  }
  if (wanted === 'sample') changes.push([[...path, 'sample'], {look_at: 'any'}]);
  if (wanted === 'frame' && effective(framePath(path)) === undefined) {
    changes.push([framePath(path), recording()?.camera_frames?.[0] ?? 'camera/optical_link']);
  }
  if (wanted === 'sensor') {
    for (const each of [[...path, 'frame_id'], ['camera_frame_id']])
      if (effective(each) !== undefined) changes.push([each, undefined]);
    if (effective([...path, 'sensor']) === undefined) changes.push([[...path, 'sensor'], 'model::link::sensor']);
  }
  change(changes);
}

function followed(path) {
  const lenses = recording()?.camera_frames ?? [];
  const here = shownPose(path);
  return [
    textField(
        framePath(path),
        {label: 'Frame of the lens (z ahead, x right, y down)', suggestions: lenses.length ? lenses : frames()}),
    h('p', {class: 'buttons'},
      h('button', {type: 'button', disabled: !here, onclick: () => changeWay(path, 'pose')}, 'Fix it here, to drag it'),
      h('span', {class: 'muted'}, here ? `at ${here.position.map((each) => fixed(each)).join(', ')} m` : '')),
  ];
}

const FORMS = [['object', 'An object'], ['point', 'A point'], ['rpy', 'Angles'], ['optical', 'Optical frame']];

function pose(path) {
  const where = [...path, 'pose'];
  const value = effective(where);
  const form = formOf(value);
  const inObject = wayOf(path) === 'mounted_on';
  const choose = (wanted) => set(where, converted(path, value, wanted));
  return [
    choice('form', 'Aimed by', FORMS, form, choose),
    h('div', {class: 'field', 'data-path': where.join('/')}, problemList(problemsAt(where))),
    form === 'optical' ?
        vectorField(
            where, ['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw'],
            {label: 'Pose of the optical frame', unit: 'm', step: 0.05, hint: ''}) :
        vectorField(
            [...where, 'position'], ['x', 'y', 'z'],
            {label: inObject ? 'Position in the object\u2019s frame' : 'Position', unit: 'm', step: 0.1, hint: ''}),
    form === 'object' ?
        choiceField(
            [...where, 'look_at'], objectNames(), {label: 'Looks at', hint: 'It follows the object\u2019s middle.'}) :
        null,
    form === 'point' ?
        vectorField([...where, 'look_at'], ['x', 'y', 'z'], {label: 'Looks at', unit: 'm', step: 0.1, hint: ''}) :
        null,
    form === 'rpy' ? vectorField([...where, 'rpy'], ['roll', 'pitch', 'yaw'], {
      label: 'Turned by',
      unit: 'rad',
      step: 0.05,
      hint: 'With zeros it looks along x; a positive pitch looks down.'
    }) :
                     null,
  ];
}

function converted(path, value, wanted) {
  const here = shownPose(path) ?? {position: [-3, 0, 2], rpy: [0, 0.4, 0]};
  const {position, rpy} = roundedPose(here, value);
  const at = value?.position ?? position;
  if (wanted === 'object') return {position: at, look_at: objectNames()[0] ?? [0, 0, 0]};
  if (wanted === 'point')
    return {position: at, look_at: orbitOfSettings(path).centre.map((each) => Number(each.toFixed(3)))};
  if (wanted === 'rpy') return {position: at, rpy};
  return opticalOf(here);
}

function opticalOf({position, rpy}) {
  const quaternion = quaternionOfMatrix(opticalOfBody(matrixOfRpy(rpy)));
  return [...position.map((each) => Number(each.toFixed(4))), ...quaternion.map((each) => Number(each.toFixed(6)))];
}

function sample(path) {
  const where = [...path, 'sample'];
  const isBox = effective([...where, 'position']) !== undefined;
  const shell = ['distance', 'elevation', 'azimuth'];
  const chooseShape = (wanted) => change(
      wanted === 'box' ?
          [
            ...shell.filter((each) => effective([...where, each]) !== undefined)
                .map((each) => [[...where, each], undefined]),
            [[...where, 'position'], {uniform: [[-2, -2, 0.5], [2, 2, 2]]}]
          ] :
          [[[...where, 'position'], undefined]]);
  return [
    textField([...where, 'look_at'], {label: 'Looks at', suggestions: ['any', 'all', ...objectNames()]}),
    choice(
        'shape', 'Position in', [['shell', 'a shell around it'], ['box', 'a box']], isBox ? 'box' : 'shell',
        chooseShape),
    isBox ?
        distribution(
            [...where, 'position'],
            {label: 'Position', range: [-10, 10], start: {uniform: [[-2, -2, 0.5], [2, 2, 2]]}, isAlways: true}) :
        [
          distribution(
              [...where, 'distance'], {label: 'Distance', range: [0.1, 10], start: {uniform: [1, 3]}, isAlways: true}),
          distribution(
              [...where, 'elevation'],
              {label: 'Above the horizon', range: [-1.5, 1.5], start: {uniform: [0.2, 1]}, isAlways: true}),
          distribution(
              [...where, 'azimuth'],
              {label: 'Direction', range: [-3.1416, 3.1416], start: {uniform: [-3.1416, 3.1416]}, isAlways: true}),
        ],
    distribution([...where, 'aim_offset'], {label: 'Looks past it by', range: [-1, 1], start: {normal: [0, 0.2]}}),
    distribution([...where, 'roll'], {label: 'About the line of sight', range: [-1, 1], start: {normal: [0, 0.06]}}),
    h('div', {class: 'pair'}, numberField([...where, 'clearance'], {label: 'Distance from everything', step: 0.05}),
      numberField([...where, 'tries'], {label: 'Positions tried', step: 100})),
  ];
}

function fromAbove() {
  const world = answer('api/world').value;
  return map({picture: world?.map, extent: world?.map_extent, ways: waysOfObjects(), label: 'The camera from above'});
}

const EFFECTS = [
  ['exposure', 'Brighter by', [-3, 3], 0.1],
  ['blur', 'Blur', [0, 5], 0.1],
  ['vignetting', 'Darker corners', [0, 1], 0.05],
  ['noise_stddev', 'Noise', [0, 0.1], 0.001],
  ['noise_mean', 'Its mean', [-0.1, 0.1], 0.001],
  ['full_well', 'Electrons of a white pixel', null, 1000],
  ['white_balance', 'White balance', [2000, 15000], 100],
  ['jpeg_quality', 'JPEG quality', [1, 100], 1],
  ['exposure_time', 'Shutter is open', [0, 0.1], 0.001],
  ['motion_samples', 'Pictures averaged over that', [2, 32], 1],
  ['readout_time', 'First row to last', [0, 0.1], 0.001],
  ['readout_bands', 'Bands of rows', [2, 480], 1],
];

function effects(path) {
  const where = [...path, 'effects'];
  return more(
      'Effects of a real sensor', EFFECTS.map(([each]) => [...where, each]),
      EFFECTS.map(
          ([name, label, range, step]) => numberField([...where, name], {label, range, step, fallback: 'off'})));
}

function depthNoise(path) {
  const where = [...path, 'depth_noise'];
  const model = effective([...where, 'model']);
  const rest = {
    structured_light: ['baseline', 'disparity_step', 'max_angle', 'min_depth', 'max_depth'],
    stereo: ['baseline', 'disparity_step', 'disparity_noise', 'min_depth', 'max_depth'],
  }[model] ??
      [];
  return more(
      'Measured depth', [[...where, 'model']],
      choiceField(
          [...where, 'model'], [['none', 'Exact'], ['structured_light', 'Structured light'], ['stereo', 'Stereo']], {
            label: 'Depth is',
            fallback: 'none',
            choose: (wanted) => set(where, wanted === 'none' ? undefined : {model: wanted}),
          }),
      h('div', {}, rest.map((each) => numberField([...where, each], {label: each.replaceAll('_', ' '), step: 0.01}))));
}

function twin(path) {
  return more(
      'Recorded pictures', [[...path, 'image_topic'], ['twin']],
      textField([...path, 'image_topic'], {label: 'Topic with its pictures'}),
      numberField([...path, 'time_offset'], {label: 'Added to their stamps', step: 0.001}),
      flowField([...path, 'correction'], {label: 'Correction of its pose'}),
      choiceField(['twin', 'output'], null, {label: 'Images are'}),
      numberField(['twin', 'every'], {label: 'Every n-th picture', step: 1}),
      numberField(
          ['twin', 'min_alignment'], {label: 'Least agreement of labels with edges', slider: true, step: 0.05}));
}
