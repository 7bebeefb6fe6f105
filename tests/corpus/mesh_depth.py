"""Depth pictures of triangle meshes and their cameras: an independent judge of csgsim's pictures.
Shares no code with csgsim. Up is +z, the vertical field of view 22.5 degrees, pixel centres are at half-integers."""
import math

import numpy as np

HALF_ANGLE = math.radians(11.25)
PROJECTIONS = ("perspective", "ortho")
# The solid is seen from above in perspective and from below without it, from directions that avoid usual planes of
# models.
DIRECTIONS = {"perspective": (0.4142, -0.7654, 0.5307), "ortho": (-0.5878, -0.6131, -0.4663)}


def load_stl(path):
    """Triangles of an ASCII STL file: an array of n x 3 x 3."""
    with open(path, encoding="ascii") as file:
        corners = [line.split()[1:] for line in file if line.lstrip().startswith("vertex")]
    return np.array(corners, float).reshape(-1, 3, 3)


def diagonal(triangles):
    return float(np.linalg.norm(triangles.max(axis=(0, 1)) - triangles.min(axis=(0, 1))))


def camera(triangles, projection):
    """Eye and centre such that the mesh fits into the picture, rounded so that their text is exact."""
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    radius = np.linalg.norm(high - low) / 2 * 1.02
    direction = np.array(DIRECTIONS[projection]) / np.linalg.norm(DIRECTIONS[projection])
    distance = radius / (math.sin if projection == "perspective" else math.tan)(HALF_ANGLE)
    centre = (low + high) / 2
    return [round(float(x), 4) for x in (*(centre + distance * direction), *centre)]


def depth(triangles, eye_and_centre, projection, size, offset=(0.0, 0.0)):
    """Distance from the eye along the view axis at every pixel's centre, moved by `offset` pixels; infinite for the
    background."""
    eye, centre = np.array(eye_and_centre[:3], float), np.array(eye_and_centre[3:], float)
    forward = (centre - eye) / np.linalg.norm(centre - eye)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    x, y, z = ((triangles - eye) @ axis for axis in (right, up, forward))
    perspective = projection == "perspective"
    reach = math.tan(HALF_ANGLE) * (z if perspective else np.linalg.norm(centre - eye))
    columns, rows = (x / reach + 1) * size / 2 - offset[0], (1 - y / reach) * size / 2 - offset[1]
    linear = 1 / z if perspective else z  # linear over the picture
    picture = np.full((size, size), np.inf)
    for triangle in zip(columns, rows, linear):
        draw_triangle(picture, *triangle, perspective)
    return picture


def draw_triangle(picture, xs, ys, ws, perspective):
    size = picture.shape[0]
    x0, x1 = max(math.floor(xs.min() - 0.5), 0), min(math.ceil(xs.max() + 0.5), size)
    y0, y1 = max(math.floor(ys.min() - 0.5), 0), min(math.ceil(ys.max() + 0.5), size)
    area = (xs[1] - xs[0]) * (ys[2] - ys[0]) - (xs[2] - xs[0]) * (ys[1] - ys[0])
    if x0 >= x1 or y0 >= y1 or area == 0:
        return
    dx = np.arange(x0, x1) + 0.5 - xs[0]
    dy = (np.arange(y0, y1) + 0.5 - ys[0])[:, None]
    b1 = (dx * (ys[2] - ys[0]) - (xs[2] - xs[0]) * dy) / area
    b2 = ((xs[1] - xs[0]) * dy - dx * (ys[1] - ys[0])) / area
    inside = (b1 >= -1e-9) & (b2 >= -1e-9) & (b1 + b2 <= 1 + 1e-9)
    w = ws[0] + b1 * (ws[1] - ws[0]) + b2 * (ws[2] - ws[0])
    block = picture[y0:y1, x0:x1]
    with np.errstate(divide="ignore"):
        z = 1 / w if perspective else w
    np.copyto(block, z, where=inside & (z < block))
