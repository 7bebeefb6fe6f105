#!/usr/bin/env python3
"""Writes the files that the models of the corpus import into data/, with reproducible bytes. Standard library only."""
import math
import struct
import zipfile
import zlib
from pathlib import Path

DATA = Path(__file__).resolve().parent / "data"


def write(name, text):
    (DATA / name).write_text(text, encoding="utf-8", newline="\n")


def star(points, outer, inner):
    """A star's corners, counterclockwise."""
    return [(radius * math.cos(math.pi * i / points), radius * math.sin(math.pi * i / points))
            for i in range(2 * points) for radius in ((outer, inner)[i % 2],)]


def star_prism(points, outer, inner, height):
    """Corners and triangles of a prism over a star; its bases are fans around their middles."""
    outline = star(points, outer, inner)
    n = len(outline)
    corners = [(x, y, z) for z in (0.0, height) for x, y in outline] + [(0.0, 0.0, 0.0), (0.0, 0.0, height)]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(2 * n, j, i), (2 * n + 1, n + i, n + j), (i, j, n + j), (i, n + j, n + i)]
    return corners, faces


def torus(around, across, large, small):
    """Corners and triangles of a torus about z."""
    corners = []
    for i in range(around):
        a = 2 * math.pi * i / around
        for j in range(across):
            b = 2 * math.pi * j / across
            r = large + small * math.cos(b)
            corners.append((r * math.cos(a), r * math.sin(a), small * math.sin(b)))
    faces = []
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, i * across + (j + 1) % across
            c, d = (i + 1) % around * across + j, (i + 1) % around * across + (j + 1) % across
            faces += [(a, c, d), (a, d, b)]
    return corners, faces


def box(low, high):
    """Corners and outward faces of a box, a quadrilateral each."""
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    return corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def triangles(faces):
    return [(face[0], face[i - 1], face[i]) for face in faces for i in range(2, len(face))]


def normal(a, b, c):
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    length = math.sqrt(sum(x * x for x in n)) or 1.0
    return [x / length for x in n]


def stl_ascii(name, corners, faces):
    lines = ["solid corpus"]
    for face in faces:
        t = [corners[i] for i in face]
        lines += ["  facet normal %.6g %.6g %.6g" % tuple(normal(*t)), "    outer loop"]
        lines += ["      vertex %.9g %.9g %.9g" % p for p in t]
        lines += ["    endloop", "  endfacet"]
    write(name, "\n".join(lines + ["endsolid corpus", ""]))


def stl_binary(name, corners, faces):
    # The header begins with "solid", as some programs write it: only the length shows that the file is binary.
    data = b"solid by csgsim, binary all the same".ljust(80) + struct.pack("<I", len(faces))
    for face in faces:
        t = [corners[i] for i in face]
        data += struct.pack("<12fH", *normal(*t), *[x for p in t for x in p], 0)
    (DATA / name).write_bytes(data)


def off(name, corners, faces, colours):
    lines = ["OFF", f"{len(corners)} {len(faces)} 0"] + ["%.6g %.6g %.6g" % p for p in corners]
    for face, colour in zip(faces, colours):
        lines.append(" ".join(str(x) for x in (len(face), *face, *colour)))
    write(name, "\n".join(lines + [""]))


def xml_mesh(corners, faces):
    """A mesh in AMF."""
    vertices = "".join("<vertex><coordinates><x>%.6g</x><y>%.6g</y><z>%.6g</z></coordinates></vertex>" % p for p in corners)
    sides = "".join("<triangle><v1>%d</v1><v2>%d</v2><v3>%d</v3></triangle>" % f for f in faces)
    return f"<mesh><vertices>{vertices}</vertices><volume>{sides}</volume></mesh>"


def amf(name, meshes):
    objects = "".join(f'<object id="{i}">{xml_mesh(*mesh)}</object>\n' for i, mesh in enumerate(meshes))
    write(name, f'<?xml version="1.0" encoding="UTF-8"?>\n<amf unit="millimeter">\n{objects}</amf>\n')


def three_mf(name, corners, faces):
    vertices = "".join('<vertex x="%.6g" y="%.6g" z="%.6g"/>' % p for p in corners)
    sides = "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in faces)
    core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
    package = "http://schemas.openxmlformats.org/package/2006"
    head = '<?xml version="1.0" encoding="UTF-8"?>\n'
    parts = {
        "[Content_Types].xml": f'{head}<Types xmlns="{package}/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
        "_rels/.rels": f'{head}<Relationships xmlns="{package}/relationships"><Relationship Target="/3D/3dmodel.model" '
        'Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
        "3D/3dmodel.model": f'{head}<model unit="millimeter" xml:lang="en-US" xmlns="{core}"><resources>'
        f'<object id="1" type="model"><mesh><vertices>{vertices}</vertices><triangles>{sides}</triangles></mesh></object>'
        '</resources><build><item objectid="1"/></build></model>',
    }
    with zipfile.ZipFile(DATA / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, text in parts.items():
            archive.writestr(zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0)), text, zipfile.ZIP_DEFLATED)


def png(name, rows, channels):
    """An 8-bit PNG: each row is a list of pixels of that many channels (1 grey, 3 red green blue, 4 with alpha)."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    raw = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    (DATA / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9))
                              + chunk(b"IEND", b""))


def hill(i, j, size):
    """A height from 0 to 1: two bumps and a pit."""
    x, y = 2 * i / (size - 1) - 1, 2 * j / (size - 1) - 1
    bumps = math.exp(-6 * ((x - 0.4) ** 2 + (y - 0.3) ** 2)) + 0.7 * math.exp(-9 * ((x + 0.5) ** 2 + (y + 0.2) ** 2))
    return max(0.0, min(1.0, 0.25 + 0.7 * bumps - 0.4 * math.exp(-20 * ((x - 0.1) ** 2 + (y + 0.5) ** 2))))


def dat(name, columns, rows):
    lines = ["# heights, the first row has the greatest y", ""]
    for j in reversed(range(rows)):
        lines.append(" ".join("%.3f" % (6 * hill(i, j, max(columns, rows))) for i in range(columns)))
    write(name, "\n".join(lines + [""]))


def dxf(name, entities, blocks=()):
    """A drawing of entities and of blocks, each a name and its entities."""
    groups = [(0, "SECTION"), (2, "BLOCKS")] if blocks else []
    for block, parts in blocks:
        groups += [(0, "BLOCK"), (8, "0"), (2, block), (10, 0), (20, 0)] + [g for part in parts for g in part] + [(0, "ENDBLK")]
    groups += [(0, "ENDSEC")] if blocks else []
    groups += [(0, "SECTION"), (2, "ENTITIES")] + [g for entity in entities for g in entity]
    groups += [(0, "ENDSEC"), (0, "EOF")]
    write(name, "".join(f"{code}\n{value}\n" for code, value in groups))


def rough(corners, faces):
    """The mesh with corners that differ by less than the resolution of 32-bit floats, a triangle without area, and one
    that occurs twice with its reverse."""
    soup = [[tuple(x * (1 + 1e-8 * ((i + k) % 3 - 1)) for x in corners[k]) for k in face] for i, face in enumerate(faces)]
    soup.append([soup[0][0], soup[0][0], soup[0][1]])
    soup += [soup[3], list(reversed(soup[3]))]
    return [corner for t in soup for corner in t], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(soup))]


def line(layer, a, b):
    return [(0, "LINE"), (8, layer), (10, a[0]), (20, a[1]), (11, b[0]), (21, b[1])]


def loop(layer, points):
    return [line(layer, points[i], points[(i + 1) % len(points)]) for i in range(len(points))]


def circle(layer, centre, radius):
    return [(0, "CIRCLE"), (8, layer), (10, centre[0]), (20, centre[1]), (40, radius)]


def arc(layer, centre, radius, start, end):
    return [(0, "ARC"), (8, layer), (10, centre[0]), (20, centre[1]), (40, radius), (50, start), (51, end)]


def polyline(layer, points, closed):
    groups = [(0, "LWPOLYLINE"), (8, layer), (90, len(points)), (70, int(closed))]
    return groups + [g for x, y in points for g in ((10, x), (20, y))]


def ellipse(layer, centre, axis, ratio):
    return [(0, "ELLIPSE"), (8, layer), (10, centre[0]), (20, centre[1]), (11, axis[0]), (21, axis[1]), (40, ratio),
            (41, 0.0), (42, 6.283185307179586)]


def insert(block, at, scale, angle):
    return [(0, "INSERT"), (8, "0"), (2, block), (10, at[0]), (20, at[1]), (41, scale[0]), (42, scale[1]), (50, angle)]


SVG = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40">
  <!-- a plate with rounded corners; each shape is filled by itself, and all are united -->
  <rect x="2" y="2" width="20" height="14" rx="3" ry="3"/>
  <circle cx="33" cy="9" r="6"/>
  <ellipse cx="50" cy="9" rx="7" ry="4"/>
  <polygon points="3,22 15,22 15,36 9,29 3,36"/>
  <g transform="translate(28 29) rotate(30)">
    <rect x="-6" y="-3" width="12" height="6"/>
    <path transform="scale(0.5)" d="M 0 -20 L 6 -12 H -6 Z"/>
  </g>
  <path d="M 42 22 h 14 v 14 h -14 z M 45 25 v 8 h 8 v -8 z"/>
</svg>
"""

SVG_CURVES = """<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 80 60">
  <path d="M 10 30 C 10 10 40 10 40 30 S 70 50 70 30 Q 78 55 40 55 T 10 30 Z"/>
  <path d="M 20 8 A 9 6 20 1 0 26 14 L 22 10 Z"/>
  <polyline points="50,4 70,4 60,16" fill="black"/>
</svg>
"""


def main():
    DATA.mkdir(exist_ok=True)
    stl_ascii("star.stl", *star_prism(5, 10, 4.5, 6))
    stl_binary("torus.stl", *torus(14, 9, 9, 3.5))
    # A prism over an L, whose bases are concave hexagons.
    outline = [(0, 0), (14, 0), (14, 5), (5, 5), (5, 11), (0, 11)]
    corners = [(x, y, z) for z in (0, 4) for x, y in outline]
    faces = [tuple(reversed(range(6))), tuple(range(6, 12))] + [(i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6)]
    off("angle.off", corners, faces, [(255, 0, 0), (0, 128, 255)] + [()] * 6)
    low, high = box((0, 0, 0), (8, 6, 4)), box((11, 1, 0), (17, 5, 9))
    amf("two_boxes.amf", [(corners, triangles(faces)) for corners, faces in (low, high)])
    three_mf("star.3mf", *star_prism(7, 9, 6, 5))
    # A shell: a box with a closed cavity inside.
    outer, inner = box((0, 0, 0), (12, 10, 8)), box((3, 2, 2), (9, 8, 6))
    stl_ascii("hollow.stl", outer[0] + inner[0],
              triangles(outer[1]) + [tuple(8 + i for i in reversed(face)) for face in triangles(inner[1])])
    dat("hills.dat", 13, 11)
    png("hills.png", [[(round(255 * hill(i, 11 - j, 12)),) for i in range(12)] for j in range(12)], 1)
    png("colours.png", [[((i * 37) % 256, (j * 53) % 256, (i * j * 11) % 256) for i in range(8)] for j in range(6)], 3)
    write("shapes.svg", SVG)
    write("curves.svg", SVG_CURVES)
    stl_ascii("rough.stl", *rough(*star_prism(4, 10, 5, 5)))
    dxf("blocks.dxf", [insert("angle", (0, 0), (1, 1), 0), insert("angle", (20, 0), (2, 1), 0), insert("angle", (10, 16), (1, 1), 30)],
        [("angle", loop("0", [(0, 0), (8, 0), (8, 3), (3, 3), (3, 10), (0, 10)]))])
    slot = [arc("slot", (8, 8), 3, 90, 270), line("slot", (8, 11), (20, 11)), line("slot", (8, 5), (20, 5)),
            arc("slot", (20, 8), 3, 270, 90)]
    dxf("shapes.dxf", loop("plate", [(0, 0), (30, 0), (30, 16), (0, 16)]) + slot
        + [circle("holes", (26, 3), 2), polyline("holes", [(24, 11), (28, 11), (28, 14), (24, 14)], True),
           ellipse("oval", (40, 8), (0, 7), 0.5)])


if __name__ == "__main__":
    main()
