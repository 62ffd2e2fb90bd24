"""Measures how many sweeps per second a lidar makes, compared with PyBullet's rayTestBatch and trimesh
with embreex: 65,536 rays in a hall with 16 moving balls of 5,000 triangles, as in benchmark/sweeps.cpp.

  sweeps.py BENCHMARK_SWEEPS [SECONDS [ROUNDS]]

All take turns, SECONDS each, and the median of ROUNDS counts. Ours casts each ray at its own time, from a
moving scanner, and gives each point all labels, normal and intensity; the others cast all rays at one
instant and give each point its object, position and normal.
"""

import math
import statistics
import subprocess
import sys
import time

import numpy as np
import pybullet
import trimesh
from trimesh.ray.ray_pyembree import RayMeshIntersector

COLUMNS, RINGS, BALLS, STEPS, REACH = 1024, 64, 16, 50, 120.0


def ball_mesh(radius=0.5):
    down, around = np.meshgrid(np.arange(STEPS + 1) * np.pi / STEPS,
                               np.arange(STEPS + 1) * 2 * np.pi / STEPS, indexing='ij')
    corners = radius * np.stack([np.sin(down) * np.cos(around), np.sin(down) * np.sin(around),
                                 np.cos(down)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(STEPS), np.arange(STEPS), indexing='ij')
    a = (i * (STEPS + 1) + j).ravel()
    b = a + STEPS + 1
    return corners, np.concatenate([np.stack([a, b, b + 1], 1), np.stack([a, b + 1, a + 1], 1)])


def wall_mesh(yaw, length=24.0):
    half = length / 2
    corners = np.array([[12, -half, -2], [12, half, -2], [12, half, 4], [12, -half, 4]], float)
    turn = np.array([[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
    return corners @ turn.T, np.array([[0, 2, 1], [0, 3, 2]])


def ball_pose(ball, t):
    angle, radius = 0.6 * t + 2 * math.pi * ball / BALLS, 4.0 + ball % 4
    return radius * math.cos(angle), radius * math.sin(angle), 0.1 * (ball % 5), t


def rays(t):
    """The origins and directions of the rays."""
    azimuth = math.pi - 2 * np.pi * np.arange(COLUMNS) / COLUMNS + t
    elevation = np.radians(np.linspace(22.5, -22.5, RINGS))
    azimuth, elevation = np.meshgrid(azimuth, elevation, indexing='ij')
    directions = np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth),
                           np.sin(elevation)], axis=-1).reshape(-1, 3)
    origin = np.array([2 * math.sin(t), -2 * math.cos(t), 0.2])
    return np.broadcast_to(origin, directions.shape), directions


class PyBullet:
    name = "PyBullet's rayTestBatch"

    def __init__(self):
        pybullet.connect(pybullet.DIRECT)
        for i in range(4):
            self.body(*wall_mesh(i * math.pi / 2))
        corners, triangles = ball_mesh()
        self.balls = [self.body(corners, triangles) for _ in range(BALLS)]

    @staticmethod
    def body(corners, triangles):
        shape = pybullet.createCollisionShape(
            pybullet.GEOM_MESH, vertices=corners.tolist(), indices=triangles.ravel().tolist(),
            flags=pybullet.GEOM_FORCE_CONCAVE_TRIMESH)
        return pybullet.createMultiBody(baseCollisionShapeIndex=shape)

    def sweep(self, t):
        for number, ball in enumerate(self.balls):
            x, y, z, yaw = ball_pose(number, t)
            pybullet.resetBasePositionAndOrientation(ball, (x, y, z),
                                                     (0, 0, math.sin(yaw / 2), math.cos(yaw / 2)))
        origins, directions = rays(t)
        ends = origins + REACH * directions
        most, points = pybullet.MAX_RAY_INTERSECTION_BATCH_SIZE - 1, 0
        for begin in range(0, len(ends), most):
            found = pybullet.rayTestBatch(origins[begin:begin + most], ends[begin:begin + most],
                                          numThreads=0)
            points += sum(body >= 0 for body, *_ in found)
        return points


class Trimesh:
    name = 'trimesh with embreex'

    def __init__(self):
        self.ball = ball_mesh()
        self.walls = [wall_mesh(i * math.pi / 2) for i in range(4)]

    def sweep(self, t):
        parts = list(self.walls)
        corners, triangles = self.ball
        for number in range(BALLS):
            x, y, z, yaw = ball_pose(number, t)
            turn = np.array([[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
            parts.append((corners @ turn.T + (x, y, z), triangles))
        starts = np.cumsum([0] + [len(corners) for corners, _ in parts])
        objects = np.repeat(np.arange(len(parts)), [len(triangles) for _, triangles in parts])
        mesh = trimesh.Trimesh(np.concatenate([corners for corners, _ in parts]),
                               np.concatenate([triangles + start for (_, triangles), start
                                               in zip(parts, starts)]), process=False)
        origins, directions = rays(t)
        triangles, ray, places = RayMeshIntersector(mesh).intersects_id(
            origins, directions, multiple_hits=False, return_locations=True)
        labels, normals = objects[triangles], mesh.face_normals[triangles]
        assert len(labels) == len(normals) == len(places) == len(ray)
        return len(ray)


def rate_of(tool, seconds):
    began, processor, sweeps, points = time.monotonic(), time.process_time(), 0, 0
    while time.monotonic() - began < seconds:
        points += tool.sweep(0.1 * sweeps)
        sweeps += 1
    return (sweeps / (time.monotonic() - began), points / sweeps,
            1000 * (time.process_time() - processor) / sweeps)


def our_rate(program, seconds):
    words = subprocess.run([program, str(seconds)], check=True, capture_output=True, text=True).stdout.split()
    return float(words[0]), float(words[words.index('rays,') + 1]), float(words[words.index('ms') - 1])


def main(program, seconds=5.0, rounds=3):
    others = [PyBullet(), Trimesh()]
    rates = {}
    for _ in range(rounds):
        found = {'ours': our_rate(program, seconds)}
        for each in others:
            found[each.name] = rate_of(each, seconds)
        for name, each in found.items():
            rates.setdefault(name, []).append(each)
    medians = {name: [statistics.median(column) for column in zip(*found)] for name, found in rates.items()}
    our_sweeps, _, our_processor = medians['ours']
    print('| | sweeps a second | times as fast is ours | processor time of a sweep | times as much as ours | points |')
    print('| --- | --- | --- | --- | --- | --- |')
    for name, (sweeps, points, processor) in medians.items():
        print(f'| {name} | {sweeps:.1f} | {our_sweeps / sweeps:.1f} | {processor:.0f} ms '
              f'| {processor / our_processor:.1f} | {points:.0f} |')


if __name__ == '__main__':
    main(sys.argv[1], *[kind(text) for kind, text in zip((float, int), sys.argv[2:])])
