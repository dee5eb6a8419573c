# Footfall in Blender: where agents can walk on the selected objects, exactly, while they are moved.
# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.app.handlers import persistent

from . import job as jobs
from . import level as levels
from . import result as results

bl_info = {
    "name": "Footfall",
    "description": "The exact area that agents can walk on, in layers, with steps, gaps and drops",
    "author": "Footfall contributors",
    "version": (1, 0, 0),
    "blender": (3, 0, 0),
    "location": "3D View > Sidebar > Footfall",
    "category": "Mesh",
}

_POLL_SECONDS = 0.05
_MISSING = "the Python module footfall is missing: install python3-footfall, or set its folder in the preferences"


class State:
    """What one session of Blender has computed; not saved in files."""

    def __init__(self):
        self.footfall = None
        self.level = None
        self.job = None
        self.area = None
        self.names = []  # of the objects that are the level
        self.message = ""
        self.answer = []
        self.is_dirty = False


state = State()


def module():
    """The module footfall. Raises ImportError with what to do."""
    if state.footfall is None:
        import sys

        entry = bpy.context.preferences.addons.get(__name__)
        folder = bpy.path.abspath(entry.preferences.folder) if entry and entry.preferences.folder else ""
        if folder and folder not in sys.path:
            sys.path.insert(0, folder)
        try:
            import footfall
        except ImportError as error:
            raise ImportError(f"{_MISSING} ({error})") from error
        state.footfall = footfall
        state.level = levels.Level(footfall)
        state.job = jobs.Job(footfall)
    return state.footfall


def changed_agent(_settings, _context):
    state.is_dirty = True


class Agent(bpy.types.PropertyGroup):
    slope: bpy.props.FloatProperty(name="Slope", description="The steepest ground that it walks on, in degrees",
                                   default=45, min=0.1, max=89.9, update=changed_agent)
    height: bpy.props.FloatProperty(name="Height", description="The free height that it needs, in metres", default=2,
                                    min=0.01, soft_max=10, update=changed_agent)
    step: bpy.props.FloatProperty(name="Step", description="How high it climbs at once, in metres", default=0.4, min=0,
                                  soft_max=2, update=changed_agent)
    gap: bpy.props.FloatProperty(name="Gap", description="How wide a gap it steps over, in metres", default=0.05, min=0,
                                 soft_max=1, update=changed_agent)
    radius: bpy.props.FloatProperty(name="Radius", description="How far its middle stays from walls and ledges, in "
                                    "metres; 0: a point", default=0, min=0, soft_max=2, update=changed_agent)
    minimum_area: bpy.props.FloatProperty(name="Least area", description="Connected parts that are no larger are left "
                                          "out, in square metres", default=1, min=0, update=changed_agent)
    is_live: bpy.props.BoolProperty(name="Live", description="Compute again when objects move or change",
                                    default=False, update=changed_agent)


def metres_per_unit(scene):
    return scene.unit_settings.scale_length if scene.unit_settings.system != "NONE" else 1.0


def compute(context):
    """Start a run over the chosen objects. Raises ImportError, ValueError."""
    module()
    scene = context.scene
    objects = [scene.objects[name] for name in state.names if name in scene.objects]
    # A run of the environment before must not go on while it is changed.
    state.job.cancel()
    state.level.update(objects, context.evaluated_depsgraph_get(), metres_per_unit(scene))
    agent = scene.footfall_agent
    environment = state.level.environment
    pipeline = environment.pipeline_for(agent.slope, agent.height, minimum_area=agent.minimum_area, step=agent.step,
                                        gap=agent.gap, radius=agent.radius)
    state.message = "computing"
    state.job.start(environment, pipeline)


def finish(context, wait=False):
    """Show the outcome of a run that has ended. Returns whether there was one."""
    outcome = state.job.take(wait) if state.job else None
    if outcome is None:
        return False
    if "area" in outcome:
        state.area = outcome["area"]
        results.show(context.scene, state.area)
        count = len(state.area.triangles)
        unit = metres_per_unit(context.scene)
        state.message = f"{state.area.area * unit * unit:.4g} m\u00b2 in {state.area.layer_count} layers, {count} triangles"
    elif "error" in outcome:
        state.message = outcome["error"]
    return True


def redraw():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def poll():
    """A timer: takes results, and starts again what has changed."""
    context = bpy.context
    if finish(context):
        redraw()
    if state.is_dirty:
        state.is_dirty = False
        if context.scene.footfall_agent.is_live and state.names:
            try:
                compute(context)
            except (ImportError, ValueError) as error:
                state.message = str(error)
            redraw()
    return _POLL_SECONDS


@persistent
def depsgraph_changed(scene, depsgraph):
    if state.is_dirty or not state.names or not scene.footfall_agent.is_live:
        return
    names = set(state.names)
    for update in depsgraph.updates:
        changed = update.id.original
        if isinstance(changed, bpy.types.Object) and changed.name_full in names:
            if update.is_updated_transform or update.is_updated_geometry:
                state.is_dirty = True
                return


@persistent
def file_loaded(_path):
    """Another file: nothing of the one before is left."""
    if state.job:
        state.job.cancel()
        state.level = levels.Level(state.footfall)
    state.area, state.names, state.message, state.answer = None, [], "", []


class FOOTFALL_OT_compute(bpy.types.Operator):
    """Compute the walkable area of the selected objects (of all visible ones when none is selected)"""
    bl_idname = "footfall.compute"
    bl_label = "Walkable Area of the Selection"

    def execute(self, context):
        chosen = context.selected_objects or context.visible_objects
        state.names = [obj.name_full for obj in chosen if levels.is_level(obj)]
        try:
            compute(context)
        except (ImportError, ValueError) as error:
            state.message = str(error)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if bpy.app.background:  # no timers there
            state.area = None
            finish(context, wait=True)
            if state.area is None:
                self.report({"ERROR"}, state.message)
                return {"CANCELLED"}
        return {"FINISHED"}


class FOOTFALL_OT_why(bpy.types.Operator):
    """Tell why the place at the 3D cursor is walkable or not"""
    bl_idname = "footfall.why"
    bl_label = "Why at the 3D Cursor?"

    @classmethod
    def poll(cls, _context):
        return state.area is not None

    def execute(self, context):
        try:
            answer = state.area.why(tuple(context.scene.cursor.location))
        except ValueError as error:
            state.answer = [str(error)]
            self.report({"WARNING"}, str(error))
            return {"CANCELLED"}
        verdict = answer.verdict.replace("_", " ")
        state.answer = [verdict if answer.filter is None else f"{verdict}, by {answer.filter}"]
        if answer.is_walkable and answer.layer is not None:
            state.answer.append(f"layer {answer.layer}, part {answer.component}")
        if answer.above is not None:
            state.answer.append(f"free height {answer.above[0]:.4g}")
        for text, distance in (("wall", answer.wall_distance), ("ledge", answer.ledge_distance)):
            if distance is not None:
                state.answer.append(f"nearest {text} at {distance:.4g}")
        self.report({"INFO"}, "; ".join(state.answer))
        return {"FINISHED"}


class FOOTFALL_PT_panel(bpy.types.Panel):
    bl_idname = "FOOTFALL_PT_panel"
    bl_label = "Footfall"
    bl_category = "Footfall"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context):
        agent = context.scene.footfall_agent
        column = self.layout.column()
        for name in ("slope", "height", "step", "gap", "radius", "minimum_area"):
            column.prop(agent, name)
        self.layout.operator(FOOTFALL_OT_compute.bl_idname, icon="MOD_REMESH")
        self.layout.prop(agent, "is_live")
        if state.job and state.job.is_running:
            self.layout.label(text=f"{state.job.step} {100 * state.job.fraction:.0f} %", icon="TIME")
        elif state.message:
            self.layout.label(text=state.message)
        self.layout.operator(FOOTFALL_OT_why.bl_idname, icon="QUESTION")
        for line in state.answer:
            self.layout.label(text=line)


class FootfallPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    folder: bpy.props.StringProperty(name="Folder of the module footfall", subtype="DIR_PATH",
                                     description="Where the folder \u201cfootfall\u201d with the Python module lies, when it is "
                                     "not installed, such as build/release/python")

    def draw(self, _context):
        self.layout.prop(self, "folder")
        try:
            self.layout.label(text=f"footfall {module().__version__}", icon="CHECKMARK")
        except ImportError as error:
            self.layout.label(text=str(error), icon="ERROR")


_CLASSES = (Agent, FOOTFALL_OT_compute, FOOTFALL_OT_why, FOOTFALL_PT_panel, FootfallPreferences)


def register():
    for one in _CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.footfall_agent = bpy.props.PointerProperty(type=Agent)
    bpy.app.handlers.depsgraph_update_post.append(depsgraph_changed)
    bpy.app.handlers.load_post.append(file_loaded)
    if not bpy.app.background:
        bpy.app.timers.register(poll, persistent=True)


def unregister():
    if state.job:
        state.job.cancel()
    if bpy.app.timers.is_registered(poll):
        bpy.app.timers.unregister(poll)
    bpy.app.handlers.load_post.remove(file_loaded)
    bpy.app.handlers.depsgraph_update_post.remove(depsgraph_changed)
    del bpy.types.Scene.footfall_agent
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
