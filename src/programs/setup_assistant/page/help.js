// The purpose of settings, in a sentence or two for whoever fills in the page, and where the documentation has more.
// config/params.yaml has the full descriptions.

// By the path in config/params.yaml: [text, section of the documentation].
const HELP = {
  'motion': ['Objects go where a recording has them, or somewhere else at random in each scene.', 'placement'],
  'bag_file': ['A bag of ROS 1 or ROS 2 with TF. Several count as one recording.', 'recordings#bags-of-ros-2'],
  'simulated_rate': ['How many scenes are made per second of the recording.', 'recordings#times'],
  'start_offset': ['This much of the recording\u2019s start is left out.', 'recordings#times'],
  'duration': ['This much after that is used; empty: all of it.', 'recordings#times'],
  'global_frame':
      ['The TF frame in which the world stands: its origin is the world\u2019s.', 'recordings#where-an-object-is'],
  'when_unknown': ['While an object\u2019s frame is not known: no scenes, or scenes without it.', 'recordings#times'],
  'max_tf_gap': ['Scenes within a longer gap in TF are left out, and counted.', 'recordings#times'],
  'stretch':
      ['Where time jumps back, the recording is cut; scenes come from this part, counted from 0.', 'recordings#times'],
  'tf_topics': ['Topics with TF; by default /tf and /tf_static.', 'recordings#topics'],
  'pose_topics': ['Topics with odometry, poses or joint states, for frames that TF lacks.', 'recordings#topics'],
  'scenes': ['How many scenes each camera makes.', 'placement#settings'],
  'placement/mode':
      ['On the ground of the world, on free cells of a map, anywhere in a box, or dropped from it.', 'placement'],
  'placement/map': ['The YAML file that map_server reads.', 'placement#maps'],
  'placement/surface': ['On the floor or table below them, or at one height.', 'placement#settings'],
  'placement/height': ['Of the objects\u2019 frames.', 'placement#settings'],
  'placement/highest_surface': ['Nothing is put on tables and shelves above this.', 'placement#settings'],
  'placement/steepest': ['Nothing is put on steeper ground.', 'placement#settings'],
  'placement/unevenness': ['How far the ground may be from flat below an object.', 'placement#settings'],
  'placement/orientation': ['Any, or upright and turned about the vertical.', 'placement#settings'],
  'placement/rows': ['In this share of the scenes, objects stand side by side.', 'placement#settings'],
  'placement/fall_time': ['A scene whose objects roll on for longer is tried again.', 'placement#settings'],
  'placement/tries': ['More tries fill narrow places, and take longer.', 'placement#settings'],
  'world': ['The SDF world around the objects: a path, or model:// or package:// and a name.', 'worlds'],
  'world/file': ['The SDF world around the objects: a path, or model:// or package:// and a name.', 'worlds'],
  'world/model_folders':
      ['Where model:// is looked up first, before the folders that Gazebo knows.', 'worlds#where-files-are-looked-for'],
  'world/on_missing_asset':
      ['A model, mesh or picture that cannot be read ends the run, or is left out.', 'worlds#what-is-missing'],
  'world/simulator':
      ['Whose rules the colours and lights were made for.', 'worlds#which-simulator-a-world-was-written-for'],
  'physics/step': ['Of the simulation in which loose things fall and are pushed.', 'worlds'],
  'physics/contact_tolerance': ['Things that overlap by more are reported.', 'worlds'],
  'physics/settle': ['How long loose things may take to come to rest before the first scene.', 'worlds'],
  'rendering/light': [
    'Simple light as Gazebo\u2019s; full adds soft shadows, and reflections of the sky.', 'models#simple-and-full-light'
  ],
  'rendering/samples': ['4 makes edges smooth. Labels are the same.', 'rendering'],
  'rendering/shadow_map_size': ['Larger makes shadows sharper, and takes longer.', 'rendering'],
  'rendering/shadow_distance': ['Nearer makes the sun\u2019s shadows sharper.', 'rendering'],
  'camera_frame_id': ['Of the optical frame: z ahead, x right, y down.', 'cameras#where-a-camera-stands'],
  'camera/frame_id': ['Of the optical frame: z ahead, x right, y down.', 'cameras#where-a-camera-stands'],
  'camera/info_topic': ['The CameraInfo that was recorded.', 'cameras#calibration-files'],
  'camera/sensor': ['A camera of the world or of a robot\u2019s model.', 'cameras#cameras-of-the-world'],
  'camera/mounted_on': ['It moves with this object.', 'cameras#on-an-object'],
  'camera/near': ['Nothing nearer is drawn.', 'cameras#what-a-lens-sees'],
  'camera/far': ['Nothing farther is drawn.', 'cameras#what-a-lens-sees'],
  'camera/rectified': ['Without distortion, as image_proc makes them.', 'cameras#rectified-cameras-and-stereo-pairs'],
  'camera/stereo_frame': [
    'Whether a right camera\u2019s frame is the left one\u2019s, as in ROS, or its own.',
    'cameras#rectified-cameras-and-stereo-pairs'
  ],
  'camera/sample/look_at':
      ['any: one of the objects in each scene; all: their middle; or one object\u2019s name.', 'cameras#at-random'],
  'camera/sample/clearance': ['The camera keeps this far from everything.', 'cameras#at-random'],
  'camera/sample/tries': ['Positions tried until one sees what it looks at.', 'cameras#at-random'],
  'camera/effects/exposure': ['In steps that double the light.', 'cameras#sensor-effects'],
  'camera/effects/blur': ['Of the lens, as a standard deviation.', 'cameras#sensor-effects'],
  'camera/effects/vignetting': ['The share of light that corners lose.', 'cameras#sensor-effects'],
  'camera/effects/white_balance': ['The light that it is set for; 6500 K is neutral.', 'cameras#sensor-effects'],
  'camera/effects/jpeg_quality': ['Of the camera\u2019s compression; empty: none.', 'cameras#sensor-effects'],
  'camera/effects/noise_stddev': ['Gaussian, as a share of white.', 'cameras#sensor-effects'],
  'camera/effects/noise_mean': ['What the noise adds on average.', 'cameras#sensor-effects'],
  'camera/effects/full_well':
      ['Fewer make more shot noise: a phone\u2019s camera has some 4000.', 'cameras#sensor-effects'],
  'camera/effects/exposure_time': ['Blurs what moves meanwhile.', 'cameras#sensor-effects'],
  'camera/effects/motion_samples': ['Each is drawn: 8 take six times as long.', 'cameras#sensor-effects'],
  'camera/effects/readout_time': ['A rolling shutter bends what moves.', 'cameras#sensor-effects'],
  'camera/effects/readout_bands': ['How finely the rolling shutter moves shadows.', 'cameras#sensor-effects'],
  'camera/depth_noise/model': ['Like a Kinect\u2019s, like a RealSense D435\u2019s, or none.', 'cameras#depth-noise'],
  'camera/image_topic': ['Real pictures get the labels of the objects in them.', 'twin#pictures'],
  'camera/time_offset': ['Where the pictures\u2019 clock is not TF\u2019s.', 'twin#times'],
  'camera/correction': ['Where the lens truly is in its frame: [x, y, z, qx, qy, qz, qw].', 'twin#make-it-right'],
  'twin/output': [
    'The recorded pictures, drawn ones of the same instants, or a dataset of each.', 'twin#real-and-synthetic-pairs'
  ],
  'twin/every': ['1 takes every picture.', 'twin#pictures'],
  'twin/min_alignment':
      ['Scenes whose labels miss the edges are left out: 0.3 is chance, 0.6 is good.', 'twin#is-it-right'],
  'alpha/class': ['What a network learns to call it.', 'labels'],
  'alpha/id': ['Tells it from others of its class.', 'labels'],
  'alpha/frame_id': ['The TF frame that it follows, without its name.', 'recordings#where-an-object-is'],
  'alpha/frame':
      ['Where the frame\u2019s name does not begin with the object\u2019s.', 'recordings#frames-without-a-prefix'],
  'alpha/pose': [
    'Where it stands in the world: {position: [x, y, z], rpy: [0, 0, 0]}, or world for the place of its model there.',
    'recordings#where-an-object-is'
  ],
  'alpha/when_unknown': ['While its frame is not known: no scenes, or scenes without it.', 'recordings#times'],
  'alpha/model': ['Its URDF, xacro or SDF file; without one, the world\u2019s model of its name.', 'models'],
  'alpha/safety_radius': ['No other object comes nearer than this.', 'placement#settings'],
  'alpha/bounding_shape': ['A box around the model, unless points say otherwise.', 'labels'],
  'alpha/keypoint_names': ['One for each, in their order.', 'labels#keypoints'],
  'alpha/skeleton': ['Pairs of keypoints with a line between them: [[front, back]].', 'labels#keypoints'],
  'alpha/link_frames':
      ['By which TF frames its links move; {object} and {link} stand for names.', 'recordings#where-an-object-is'],
  'alpha/parts':
      ['Groups of links with labels of their own: {gripper: [hand, "finger_*"]}.', 'labels#parts-of-objects'],
  'alpha/model_arguments': ['What the xacro file is given: {prefix: left_}.', 'models#xacro'],
  'classes': ['Their order gives their numbers, from 0; by default alphabetical.', 'labels'],
  'world_classes': ['Classes of the surroundings, for semantic and panoptic labels.', 'labels#classes-of-the-world'],
  'labels/min_visibility': ['Objects of which less is seen get no label.', 'labels#which-objects-get-labels'],
  'labels/min_pixels': ['Objects with fewer get no label.', 'labels#which-objects-get-labels'],
  'labels/keypoint_tolerance': ['Points up to this far below a surface count as seen.', 'labels#keypoints'],
  'labels/glass': ['Whose glass is labelled, instead of what is seen through it.', 'labels#glass'],
  'randomize/preset':
      ['What helped networks most with photographs: light, paint, backgrounds, clutter, wear.', 'transfer'],
  'seed': [
    'Another number draws everything anew; the same one makes the same dataset.', 'randomize#what-the-draws-depend-on'
  ],
  'output_folder': ['Each format gets a folder in it.', 'settings'],
  'if_exists': ['An existing dataset is continued, replaced, or left alone.', 'reliability#what-is-promised'],
  'split/by': ['Neighbours in time look alike, so blocks test more honestly.', 'labels#splits'],
  'split/gap': ['This much time between train, val and test is left out.', 'labels#splits'],
  'image/png_compression': ['0 is fastest; above 1, a tenth smaller in four times the time.', 'formats'],
  'image/jpeg_quality': ['Of formats that write JPEG.', 'formats'],
  'masks/method': ['Exact ones, or background subtraction as in the paper.', 'labels#background-subtraction'],
  'background_subtractor/history_length': ['1 is as good as the original\u2019s 100.', 'labels#background-subtraction'],
  'background_subtractor/var_threshold':
      ['Lower finds objects that look like what is behind them.', 'labels#background-subtraction'],
  'processes': ['One for every two cores; the dataset is the same.', 'performance'],
  'sync': ['A power cut costs what was not yet on the disk.', 'reliability#what-is-promised'],
};

// {text, document, section}; undefined if the page has no text of its own.
export function helpOf(path) {
  const known = HELP[path];
  if (!known) return undefined;
  const [document, section = ''] = known[1].split('#');
  return {text: known[0], document, section};
}

export function helpedPaths() {
  return Object.keys(HELP);
}
