"""Meshes in Wavefront's OBJ and MTL formats."""

import os
from typing import Dict, List, NamedTuple, Optional, Tuple

from example.shapes import Shape, face_normal
from example.geometry import length

Colour = Tuple[float, float, float]  # sRGB-encoded, 0..1


class Material(NamedTuple):
    diffuse: Colour = (1.0, 1.0, 1.0)  # times the texture's colour
    roughness: float = 0.6             # 0 mirror .. 1 chalk
    metalness: float = 0.0
    specular: float = 0.5              # 0.5: 4 % reflected head-on, as by most plastics and paints
    emissive: Colour = (0.0, 0.0, 0.0)
    texture: Optional[str] = None      # file beside the mesh


class MeshFile:
    """Collects shapes by material and writes them as NAME.obj and NAME.mtl."""

    def __init__(self, materials: Dict[str, Material]):
        self._materials = materials
        self._shapes: Dict[str, List[Shape]] = {}

    def add(self, material: str, *shapes: Shape) -> None:
        if material not in self._materials:
            raise KeyError(f"no material '{material}'")
        self._shapes.setdefault(material, []).extend(shapes)

    def without(self, *materials: str) -> "MeshFile":
        rest = MeshFile(self._materials)
        rest._shapes = {key: shapes for key, shapes in self._shapes.items()
                        if key not in materials}
        return rest

    def only(self, *materials: str) -> "MeshFile":
        return self.without(*(key for key in self._shapes if key not in materials))

    def write(self, folder: str, name: str) -> None:
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, name + ".mtl"), "w", encoding="ascii") as file:
            file.write("\n".join(_material_lines(key, self._materials[key])
                                 for key in self._shapes))
        with open(os.path.join(folder, name + ".obj"), "w", encoding="ascii") as file:
            file.write("\n".join(self._lines(name)) + "\n")

    def _lines(self, name: str) -> List[str]:
        positions, normals, coordinates = _Table("v"), _Table("vn"), _Table("vt")
        faces: List[str] = []
        for material, shapes in self._shapes.items():
            faces += ["g " + material, "usemtl " + material]
            for polygon in (polygon for shape in shapes for polygon in shape):
                corners = [f"{positions.index(c.position)}/{coordinates.index(c.coordinates)}"
                           f"/{normals.index(c.normal)}" for c in polygon]
                for k in range(1, len(polygon) - 1):
                    if length(face_normal([polygon[0], polygon[k], polygon[k + 1]])) > 1e-9:
                        faces.append(f"f {corners[0]} {corners[k]} {corners[k + 1]}")
        header = [f"# {name}: made by scripts/make_example.py", f"mtllib {name}.mtl", "o " + name]
        return header + positions.lines + coordinates.lines + normals.lines + faces


class _Table:
    """Numbers each different tuple once, from 1 as OBJ counts."""

    def __init__(self, keyword: str):
        self.lines: List[str] = []
        self._keyword = keyword
        self._indices: Dict[str, int] = {}

    def index(self, values: Tuple[float, ...]) -> int:
        # Adding 0.0 turns a negative zero into a positive one.
        text = " ".join(f"{round(value, 4) + 0.0:.4f}".rstrip("0").rstrip(".") for value in values)
        if text not in self._indices:
            self.lines.append(f"{self._keyword} {text}")
            self._indices[text] = len(self.lines)
        return self._indices[text]


def _material_lines(name: str, material: Material) -> str:
    # Ns is the Blinn-Phong exponent for the same lobe: 2 / alpha^2 - 2 with alpha = roughness^2
    # (Walter et al. 2007). Pr and Pm are the common extension for roughness and metalness.
    exponent = max(2.0 / material.roughness ** 4 - 2.0, 0.0)
    lines = [f"newmtl {name}",
             "Ka 0 0 0",
             "Kd {:.3f} {:.3f} {:.3f}".format(*material.diffuse),
             "Ks {0:.3f} {0:.3f} {0:.3f}".format(material.specular),
             "Ke {:.3f} {:.3f} {:.3f}".format(*material.emissive),
             f"Ns {min(exponent, 1000.0):.1f}",
             f"Pr {material.roughness:.3f}",
             f"Pm {material.metalness:.3f}",
             "illum 2"]
    if material.texture:
        lines.append("map_Kd " + material.texture)
    return "\n".join(lines) + "\n"
