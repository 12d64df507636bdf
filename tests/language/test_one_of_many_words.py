"""Words that mean the same in one place: verbs of making and placing, what is thought of a figure, how it is wished."""

from __future__ import annotations

import pytest

from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

MAKING = (
    "build|make|create|construct|form|assemble|erect|raise|produce|generate|compose|design|craft|set up|put up|put "
    "together|stack up|lay out|do|fashion|prepare|arrange|establish|configure|realise|realize|get me|give me|show "
    "me|bring me|shape|install|pile up|rig up|throw together|knock together|whip up|cobble together|knock "
    "up|render|engineer|manufacture|fabricate|implement|put|place|have|get|let me see|let me have|try building|start "
    "building|begin building|go build|go and build|come up "
    "with|provide|deliver|reproduce|recreate|complete|present|sculpt|conjure up|piece together|make up"
).split("|")

PLACING = (
    "put|place|set|lay|stack|position|rest|drop|move|stick|plop|pop|slap|park|seat|mount|deposit|locate|situate|install|balance|perch|sit|stand|bring|transfer|relocate|shift|slide|push|carry|take|hoist|lift|haul|toss|dump|chuck|shove|plonk|plant|lodge|get|lower|arrange|pile|pick "
    "up and place|pick and place|grab and put|pick up and "
    "put|nudge|have|keep|let|raise|reposition|plunk|whack|fit|store|tuck|settle|land|load|gently set|carefully "
    "place|now put|then put|go put|go and put|try to put|try putting|remember to put|be sure to put|start by "
    "putting|make sure to put|don't forget to put|proceed to put"
).split("|")

PRAISING = (
    "high|stable|sturdy|solid|gorgeous|perfect|simple|basic|classic|single|separate|compact|clean|careful|proud|big|large|small|long|short|little|tiny|huge|cute|fancy|lovely|pretty|nice|neat|tidy|beautiful|good|proper|wonderful|magnificent|great|fine|decent|mighty|impressive|elegant|straight|vertical|colourful|colorful|steady|firm|robust|plain|ordinary|regular|normal|standard|usual|typical|new|fresh|quick|complete|whole|full|entire|final|target|desired|required|requested|actual|freestanding|free-standing|upright|safe|amazing|awesome|fantastic|fun|funny|sweet|smart|crazy|epic|sick|dope|majestic|grand|modest|humble|little "
    "red|correct|valid|orderly|monochrome|monochromatic"
).split("|")

WISHING = (
    "I want|I'd like|I'd like to have|I'd love|I would prefer|I wish for|I'd appreciate|I require|I request|we "
    "need|need|want|gimme|can I get|can I have|could we have|may I have|let there be|there should be|there must "
    "be|there has to be|we should have|we want to end up with|I want to end up with|the goal is|the target state "
    "is|the desired outcome is|the desired result:|the task:|success means|the end result should be|in the end I "
    "want|at the end there should be|finally there should be|Goal:|Desired end state:|Final configuration:|Final "
    "state:|End state:|Target:|Target configuration:|make sure there is|make sure we have|ensure there is|see to it "
    "that there is|I'm looking for|we're looking for|I am after|what I want is|what I need is|what we need is|all I "
    "want is|the only thing I want is|how about|what about|why not|let's have|let's see|let us have|show|I'd be happy "
    "with|I imagine|imagine|picture|I expect|I expect to see|I'd expect|I should see|you should see|the camera should "
    "see|one should see|everyone should see|I want to see|I hope to see|I'd like to see|we would like to get|I'm "
    "dreaming of|I dream of|today we need|today I want|today's task is|today's job:|our next task is|next "
    "up:|next:|order:|request:|ticket:|TODO:|my wish is|my wish:|my request is|my order is|for me please|the customer "
    "wants|the boss wants|my son wants|the children want|my teacher asked for|the client ordered|they asked for|he "
    "asked for|they need|the plan calls for|the spec calls for|the task calls for|the drawing shows|the picture "
    "shows|the blueprint shows|it is simple:|simple task:|quick one:|easy one:|warm-up:|exercise:|exercise 3:|task "
    "4:|problem 2:|challenge:|scenario:|scene:|setup:|layout:|the scene:|the result is|the outcome is|the outcome "
    "should be|the output is|the output should be|expected "
    "result:|expected:|result:|output:|wanted:|needed:|desired:|please give us|be so kind as to make|kindly provide|I "
    "would like for there to be|I need there to be|there needs to be|there shall be|there ought to be|what remains at "
    "the end is|we end with|it ends with|it should end up as|you end up with|the episode ends with|the episode is "
    "successful if there is|success if there is|success iff there is|success condition:|success criterion:|pass "
    "condition:|done when there is|it counts as done when there is|the robot is done when there is|you win if there "
    "is|you win when there is|the agent must produce|the agent has to build|the robot arm should build|robot should "
    "make|the arm must erect|your job is to build|your mission is to construct|the job is making|have the robot "
    "make|have the arm build|get the robot to build|tell the robot to make|let the robot build|program the robot to "
    "build|I need the robot to build|I want the robot to make|I'd like the arm to build|use the arm to build|using "
    "the gripper, build|with the gripper, build|it would be nice to have|it would be great to get|it'd be cool to "
    "see|it would be lovely if there was|it would be lovely if you built|would you mind building|would you please "
    "build|would you be able to build|do you think you could build|do you know how to build|is it possible to "
    "build|is it possible to have|could you possibly build|can you manage to build|can you try to build|are you able "
    "to build|I bet you can't build|bet you can build|I dare you to build|try and build|why don't you build|shall we "
    "build|should we build|I was wondering if you could build|I was hoping you could build|I was hoping for|I wonder "
    "if you can build|I'd be glad if you built|I'd be grateful for|we'd be delighted with|please try to make|go ahead "
    "and make|just make|now make|ok so make|hey, make|hi robot, make|dear robot, please make|listen, make|yo "
    "make|alright, make|first of all, make|to begin, make|for starters, make|let's try|let's build|let's go for|go "
    "for|I'd settle for|I'd choose|I choose|I pick|I vote for|give us|hand me|get us|fetch me|bring us|make me|make "
    "us|build us|build me|one more time:|here's what I want:|here is what to do:|here's the deal:|this is what I "
    "need:|this is the goal:|that's the goal:|all you have to do is build|you only have to build|you just need to "
    "build|you must build|you should build|you need to build|you have to build|you are to build|you will build|you "
    "shall build|we must build|we have to build|we are going to build|we're building|we are building|I'm going to "
    "build|I will build|I have to build|I need to build|I must build|they are building|she wants to build|mom wants "
    "me to build|my daughter would love|my nephew would like|my little brother wants|grandpa would like to see|our "
    "professor wants|the spec says:|the instructions say:|instructions:|it says here:|the card says:|per the spec:|as "
    "specified:|as discussed:|as agreed:|as per the drawing:|according to the plan:|according to the "
    "manual,|following the plan,|in this task,|in this episode,|in this scene,|in the final scene,|in the end,|at the "
    "end,|at the end of the episode,|by the end,|when you're done,|when "
    "finished,|afterwards,|eventually,|ultimately,|in the final state,|in the goal state,|as a result,|on the "
    "table,|on the table there should be|on the table I want|in front of me I want|here I want|somewhere on the "
    "table,|anywhere on the table,"
).split("|")

TOWER, ON = "build a tower of three red blocks", "put the red block on the blue block"
SAID = [
    *((f"{verb} a tower of three red blocks", TOWER) for verb in MAKING),
    *((f"{verb} the red block on the blue block", ON) for verb in PLACING),
    *((f"build a {fine} tower of three red blocks", TOWER) for fine in PRAISING),
    *((f"{wish} a tower of three red blocks", TOWER) for wish in WISHING),
]


@pytest.mark.parametrize(("said", "plainly"), SAID)
def test_the_same_task(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    expected, _ = BuiltinFrontEnd().read(plainly)
    assert task is not None and expected is not None and same(task, expected)
