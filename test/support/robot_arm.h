#pragma once

/// A small robot as URDF: a base on the ground, and an arm of three links on it.

#include <string>

namespace synthetic_dataset::test {

/// With every joint at 0 the arm stands upright: base (a box of 0.4 x 0.4 x 0.2 m, from the ground
/// up), upper (0.5 m, turns about z on the base), fore (0.4 m, turns about y at the elbow), gripper
/// (a ball of 0.06 m, slides along z). `nose` is fixed to the base and has no shape.
inline constexpr char kRobotArm[] = R"(<?xml version="1.0"?>
<robot name="arm">
  <material name="red"><color rgba="0.9 0.1 0.1 1"/></material>
  <link name="base_link"><visual><origin xyz="0 0 0.1"/>
    <geometry><box size="0.4 0.4 0.2"/></geometry><material name="red"/></visual>
    <collision><origin xyz="0 0 0.1"/><geometry><box size="0.4 0.4 0.2"/></geometry></collision></link>
  <link name="nose"/>
  <joint name="nose_mount" type="fixed"><parent link="base_link"/><child link="nose"/>
    <origin xyz="0.2 0 0.1"/></joint>
  <link name="upper"><visual><origin xyz="0 0 0.25"/>
    <geometry><box size="0.1 0.1 0.5"/></geometry></visual>
    <collision><origin xyz="0 0 0.25"/><geometry><box size="0.1 0.1 0.5"/></geometry></collision></link>
  <joint name="shoulder" type="continuous"><parent link="base_link"/><child link="upper"/>
    <origin xyz="0 0 0.2"/><axis xyz="0 0 1"/></joint>
  <link name="fore"><visual><origin xyz="0 0 0.2"/>
    <geometry><cylinder radius="0.04" length="0.4"/></geometry></visual>
    <collision><origin xyz="0 0 0.2"/><geometry><cylinder radius="0.04" length="0.4"/></geometry></collision></link>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0 0 0.5"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <link name="gripper"><visual><geometry><sphere radius="0.06"/></geometry></visual></link>
  <joint name="slide" type="prismatic"><parent link="fore"/><child link="gripper"/>
    <origin xyz="0 0 0.42"/><axis xyz="0 0 1"/><limit lower="0" upper="0.1" effort="1" velocity="1"/></joint>
</robot>
)";

}  // namespace synthetic_dataset::test
