# SPDX-License-Identifier: MIT
"""What an update of Blender's Line Art costs:

    blender --background --factory-startup --python benchmarks/blender_line_art.py -- MESH.obj SIDE_PX

The mesh alone, four units large, seen as the paper's scene sees it; before each update the camera moves a little.
Prints the fastest of ten updates in ms as a line "line_art MS STROKES".
"""
import sys
import time

import bpy
from mathutils import Vector

mesh_file, side_px = sys.argv[sys.argv.index("--") + 1:][:2]

for scene_object in list(bpy.data.objects):
    bpy.data.objects.remove(scene_object)
bpy.ops.import_scene.obj(filepath=mesh_file, axis_forward="-Z", axis_up="Y")
model = bpy.context.selected_objects[0]
model.matrix_world.identity()
corners = [Vector(corner) for corner in model.bound_box]
low = Vector(min(corner[axis] for corner in corners) for axis in range(3))
high = Vector(max(corner[axis] for corner in corners) for axis in range(3))
size = 4.0 / max(high - low)
model.scale = (size, size, size)
model.location = -size * (low + high) / 2
model.location.y = -size * low.y

camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
bpy.context.collection.objects.link(camera)
bpy.context.scene.camera = camera
camera.data.sensor_fit = "VERTICAL"
camera.data.angle = 0.6632251  # 38 degrees
camera.location = (2.4, 3.5, 9.6)
camera.rotation_mode = "QUATERNION"
camera.rotation_quaternion = (Vector((0.8, 1.55, 0.0)) - camera.location).to_track_quat("-Z", "Y")
render = bpy.context.scene.render
render.resolution_x = render.resolution_y = int(side_px)

bpy.ops.object.gpencil_add(type="LRT_SCENE")
line_art = bpy.context.object
modifier = line_art.grease_pencil_modifiers[0]
modifier.use_contour = modifier.use_crease = modifier.use_edge_mark = modifier.use_intersection = True
modifier.crease_threshold = 2.4434610  # 140 degrees between faces: 40 between normals


def update():
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    layer = line_art.evaluated_get(graph).data.layers[0]
    return len(layer.frames[0].strokes)


update()
fastest = float("inf")
for i in range(10):
    camera.location.x += 1e-3
    start = time.perf_counter()
    strokes = update()
    fastest = min(fastest, time.perf_counter() - start)
print(f"line_art {1000 * fastest:.1f} {strokes}")
