"""A free-flying parallel gripper: a hand that a servo of limited force draws to a target pose, and two fingers.

The hand points down at its home pose, its fingers opening along y. Translations and rotations are in the world frame.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from rpg.blocks import camera
from rpg.blocks.state import Quat, Vec3, product
from rpg.env.embodiment import Action

HOME = (0.33, 0.0, 1.40)
"""Where the grasp centre, between the finger tips, is at the start."""
OPENING, WIDE = 0.10, 0.098
"""Greatest distance between the fingers (m), and from where on they hold nothing."""
REACH_X, REACH_Y, REACH_Z = (0.15, 0.95), (-0.60, 0.60), (0.964, 2.40)
"""The grasp centre's target stays within these bounds."""
STEP_LIMIT, TURN_LIMIT = 0.03, 0.25
"""Greatest translation (m, along each axis) and rotation (rad, about each axis) of one action."""
LEAD = 0.04
"""The target keeps within this distance (m) of the hand, so that pushing against something does not wind up."""
STIFFNESS, DAMPING, FORCE = 4000.0, 130.0, 30.0
"""Of the servo that draws the hand to its target: N/m, N s/m, and its greatest force (N) along each axis."""
TURN_STIFFNESS, TURN_DAMPING, TORQUE = 6.0, 0.2, 5.0
"""The same for turning: N m/rad, N m s/rad, N m."""
MIDDLE = 0.092
"""Height (m) of the hand's centre of mass, where the servo acts, over the grasp centre."""
GRIP_STEP = 0.02
"""By how much (m) an action of +1 or -1 opens or closes the fingers in one step."""
GRIP_FORCE = 20.0
FINGER_LENGTH, FINGER_WIDTH, FINGER_THICKNESS = 0.07, 0.018, 0.012
GRASP_DEPTH = 0.012
"""The grasp centre lies this far (m) above the finger tips."""
DARK, LIGHT = [0.22, 0.24, 0.27, 1.0], [0.55, 0.58, 0.62, 1.0]


@dataclass(frozen=True)
class FloatingGripper:
    """The embodiment: adds the gripper to a scene and binds to it."""

    def attach(self, spec: mujoco.MjSpec) -> None:
        """Add the hand, its fingers and the target that it follows."""
        world = spec.worldbody
        target = world.add_body(name="hand_target", mocap=True, pos=list(HOME))
        target.add_site(name="hand_target", pos=[0.0, 0.0, MIDDLE], size=[0.003] * 3, rgba=[0.0, 0.0, 0.0, 0.0])
        hand = world.add_body(name="hand", pos=list(HOME), gravcomp=1.0)
        hand.add_freejoint(name="hand")
        palm = FINGER_LENGTH - GRASP_DEPTH
        _box(hand, "palm", [0.022, OPENING / 2 + 0.02, 0.018], [0.0, 0.0, palm + 0.018], LIGHT, mass=0.6)
        _box(hand, "wrist", [0.024, 0.024, 0.04], [0.0, 0.0, palm + 0.076], DARK, mass=0.4)
        hand.add_site(name="hand", pos=[0.0, 0.0, MIDDLE], size=[0.003] * 3, rgba=[0.0, 0.0, 0.0, 0.0])
        behind, height = 0.08, palm + 0.01
        down = math.degrees(math.atan2(-height, behind))
        hand.add_camera(name="wrist", pos=[-behind, 0.0, height], quat=list(camera.orientation(down)), fovy=70.0)
        for name, side in (("left_finger", 1.0), ("right_finger", -1.0)):
            finger = hand.add_body(name=name, gravcomp=1.0)
            finger.add_joint(
                name=name,
                type=mujoco.mjtJoint.mjJNT_SLIDE,
                axis=[0.0, side, 0.0],
                range=[0.0, OPENING / 2],
                limited=True,
                damping=2.0,
                armature=0.05,
                ref=0.0,
            )
            half = [FINGER_WIDTH / 2, FINGER_THICKNESS / 2, FINGER_LENGTH / 2]
            place = [0.0, side * FINGER_THICKNESS / 2, FINGER_LENGTH / 2 - GRASP_DEPTH]
            _box(finger, name, half, place, DARK, mass=0.05)
        self._servo(spec)
        self._couple(spec)

    def _servo(self, spec: mujoco.MjSpec) -> None:
        """Six actuators that draw the hand to its target, each with a limited force or torque."""
        for kind, stiffness, damping, limit, first in (
            ("force", STIFFNESS, DAMPING, FORCE, 0),
            ("torque", TURN_STIFFNESS, TURN_DAMPING, TORQUE, 3),
        ):
            for k, axis in enumerate("xyz"):
                gear = [0.0] * 6
                gear[first + k] = 1.0
                actuator = spec.add_actuator(
                    name=f"{kind} {axis}",
                    trntype=mujoco.mjtTrn.mjTRN_SITE,
                    target="hand",
                    refsite="hand_target",
                    gear=gear,
                    forcerange=[-limit, limit],
                    forcelimited=True,
                )
                actuator.set_to_position(kp=stiffness, kv=damping)

    def _couple(self, spec: mujoco.MjSpec) -> None:
        """The fingers' common motion, and the actuator that closes them."""
        mimic = spec.add_equality(
            name="fingers",
            type=mujoco.mjtEq.mjEQ_JOINT,
            objtype=mujoco.mjtObj.mjOBJ_JOINT,
            name1="left_finger",
            name2="right_finger",
            solref=[0.01, 1.0],
            solimp=[0.95, 0.99, 0.001, 0.5, 2.0],
        )
        mimic.data[:5] = [0.0, 1.0, 0.0, 0.0, 0.0]
        tendon = spec.add_tendon(name="fingers")
        tendon.wrap_joint("left_finger", 0.5)
        tendon.wrap_joint("right_finger", 0.5)
        actuator = spec.add_actuator(
            name="fingers",
            trntype=mujoco.mjtTrn.mjTRN_TENDON,
            target="fingers",
            ctrlrange=[0.0, OPENING / 2],
            ctrllimited=True,
            forcerange=[-2 * GRIP_FORCE, 2 * GRIP_FORCE],
            forcelimited=True,
        )
        actuator.set_to_position(kp=1500.0, kv=60.0)

    def bind(self, model: mujoco.MjModel, blocks: tuple[str, ...]) -> BoundGripper:
        """The gripper of a compiled scene."""
        return BoundGripper(model, blocks)


def _box(
    body: mujoco.MjsBody, name: str, half: list[float], place: list[float], rgba: list[float], mass: float
) -> None:
    body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=half,
        pos=place,
        rgba=rgba,
        mass=mass,
        condim=4,
        friction=[1.5, 0.02, 0.0001],
        solref=[0.01, 1.0],
        solimp=[0.98, 0.995, 0.001, 0.5, 2.0],
        priority=1,
    )


class BoundGripper:
    """The gripper of one scene. Proprioception: position (3), quaternion (4), opening (m)."""

    proprioception_size = 8

    def __init__(self, model: mujoco.MjModel, blocks: tuple[str, ...]) -> None:
        self._hand = int(model.joint("hand").qposadr[0])
        self._fingers = [int(model.joint(name).qposadr[0]) for name in ("left_finger", "right_finger")]
        self._sensed = slice(self._hand, self._hand + self.proprioception_size)
        self._mocap = int(model.body("hand_target").mocapid[0])
        self._actuator = int(model.actuator("fingers").id)
        self._pads = {int(model.geom("left_finger").id): 1, int(model.geom("right_finger").id): 2}
        self._blocks = {int(model.geom(name).id): name for name in blocks}
        self._target: list[float] = list(HOME)
        self._quat: Quat = (1.0, 0.0, 0.0, 0.0)
        self._opening = OPENING

    @property
    def target(self) -> Vec3:
        """Where the actions so far have sent the grasp centre; a controller adds its deltas to this."""
        x, y, z = self._target
        return (x, y, z)

    def reset(self, data: mujoco.MjData) -> None:
        """Home, fingers open."""
        self._target, self._quat, self._opening = list(HOME), (1.0, 0.0, 0.0, 0.0), OPENING
        for adr in self._fingers:
            data.qpos[adr] = OPENING / 2
        data.ctrl[self._actuator] = OPENING / 2
        mujoco.mj_forward(data.model, data)

    def command(self, data: mujoco.MjData, action: Action) -> None:
        """Move the target by a delta, clipped to the limits of one step and of the reach; open or close a little."""
        dx, dy, dz, rx, ry, rz, grip = action.tolist()
        if dx or dy or dz or rx or ry or rz:
            self._move(data, (dx, dy, dz))
            self._turn((rx, ry, rz))
            data.mocap_pos[self._mocap] = self._target
            data.mocap_quat[self._mocap] = self._quat
        if grip:
            change = GRIP_STEP * max(-1.0, min(1.0, grip))
            self._opening = max(0.0, min(OPENING, self._opening + change))
            data.ctrl[self._actuator] = self._opening / 2

    def held(self, data: mujoco.MjData) -> frozenset[str]:
        """Blocks that both fingers touch."""
        if data.ncon == 0 or data.qpos[self._fingers[0]] > WIDE / 2:
            return frozenset()
        touched: dict[int, int] = {}
        for a, b in data.contact.geom.tolist():
            for pad, other in ((a, b), (b, a)):
                if pad in self._pads and other in self._blocks:
                    touched[other] = touched.get(other, 0) | self._pads[pad]
        return frozenset(self._blocks[geom] for geom, sides in touched.items() if sides == 3)

    def proprioception(self, data: mujoco.MjData) -> NDArray[np.float64]:
        """Position and quaternion of the grasp centre in the world, and the opening between the fingers."""
        places = data.qpos
        # the fingers follow the hand in the model's coordinates, so that one copy has all but the second of them
        sensed: NDArray[np.float64] = places[self._sensed].copy()
        sensed[7] += places[self._fingers[1]]
        return sensed

    def _move(self, data: mujoco.MjData, delta: tuple[float, float, float]) -> None:
        actual: list[float] = data.qpos[self._hand : self._hand + 3].tolist()
        for k, (low, high) in enumerate((REACH_X, REACH_Y, REACH_Z)):
            target = self._target[k] + max(-STEP_LIMIT, min(STEP_LIMIT, delta[k]))
            target = max(actual[k] - LEAD, min(actual[k] + LEAD, target))
            self._target[k] = max(low, min(high, target))

    def _turn(self, rotation: tuple[float, float, float]) -> None:
        clipped = [max(-TURN_LIMIT, min(TURN_LIMIT, angle)) for angle in rotation]
        angle = math.sqrt(sum(part * part for part in clipped))
        if angle > 0.0:
            s = math.sin(angle / 2) / angle
            turn = (math.cos(angle / 2), clipped[0] * s, clipped[1] * s, clipped[2] * s)
            self._quat = _normalised(product(turn, self._quat))


def _normalised(q: Quat) -> Quat:
    length = math.sqrt(sum(part * part for part in q))
    w, x, y, z = (part / length for part in q)
    return (w, x, y, z)
