"""Words around an instruction that carry nothing of it: politeness, wishes, questions, steps. Closed lists."""

from __future__ import annotations

from rpg.language.grammar.talk.slots import Phrases

COMMAND_FRAMES = Phrases(
    "want to",
    "pls", "plz", "please just", "also ,", "additionally ,", "the task :", "the goal :", "your task :",
    "the task itself :",
    "the job itself :", "the actual task :", "the actual job :", "the real task :", "the real job :", "note to self :",
    "note to myself :", "note :", "reminder :", "reminder to self :", "robot has to", "robot must",
    "robot should", "requirement",
    "requirement :", "requirement -", "i would prefer you to",
    "i 'd love you to", "i would love you to", "i would like to ask you to", "may i ask you to", "do me a favor and",
    "feel free to", "goal -", "task -", "and now", "first off", "first off ,",
    "the agent must", "the agent should", "the agent has to", "the agent needs to", "the manipulator should",
    "the machine should", "agent", "build me", "the gripper should", "the robot arm should", "the robot arm must",
    "for this task ,", "in this task ,", "in this task",
    "please", "kindly", "can you", "could you", "would you", "will you", "can you please", "could you please",
    "would you please", "would you mind",
    "i want you to", "i would like you to", "i need you to", "i want to", "i would like to", "i would love to",
    "we want to", "we need to", "i need to",
    "you should", "you must", "you need to", "you have to", "you can", "you are to", "the robot should",
    "the robot must", "the robot has to", "the robot needs to", "the robot can",
    "robot", "the arm should", "let us", "try to", "just", "simply", "now", "go ahead and", "your task is to",
    "your job is to", "the task is to", "the goal is to",
    "the objective is to", "your goal is to", "i wish to", "help me", "help me to", "next", "i am trying to",
    "try and", "make sure to", "make sure you", "be sure to",
    "hey", "hi", "hello", "ok", "okay", "so", "well", "alright", "hey robot", "task", "goal", "instruction", "also",
    "additionally", "in addition", "in addition ,", "furthermore", "furthermore ,", "moreover", "moreover ,",
    "first of all", "to start",
    "the aim is to", "see if you can", "i will need you to", "proceed to", "you will", "you will need to",
    "how about you", "attempt to", "remember to",
    "task :", "goal :", "instruction :", "is it possible to", "can we", "could we", "shall we", "should we",
    "we should", "we must", "the challenge is to", "it should be possible to",
    "in the end", "at the end", "in the end ,", "at the end ,", "i 'd like to", "do", "want you to", "need you to",
    "the robot will", "get the robot to", "have the robot",
    "take care to", "would it be possible to", "may i ask you to", "i ask you to",
    "today", "and", "then", "robot ,", "please ,", "ok ,", "okay ,", "hi ,", "hello ,", "hey ,",
    "so ,", "now ,", "hi robot", "hello robot", "dear robot", "i would appreciate it if you could",
    "it would be great if you could", "i would like it if you could", "your mission is to", "you are asked to",
    "use the robot to", "using the robot arm ,", "using the robot ,", "with the robot arm ,", "use the robot arm to",
    "use your gripper to", "use the gripper to", "using the gripper ,",
)  # fmt: skip
STATE_FRAMES = Phrases(
    "want to see", "want to have", "arrange that", "arrange it that",
    "the scene shows", "the final scene shows", "the picture shows", "the goal shows", "the image shows",
    "level 1 :", "level 2 :", "level 3 :",
    "end :", "at the end :", "in the end :", "finally :", "final :", "after :", "end state :", "finish :",
    "final state :",
    "i 'd love", "i would love", "i 'd love to see", "i 'd like", "i 'd like to see", "i would prefer", "i prefer",
    "i imagine", "also", "also ,", "additionally", "in addition", "in addition ,", "furthermore",
    "furthermore ,", "moreover", "moreover ,", "requirement", "requirement :", "requirement -",
    "the task :", "the goal :", "goal :", "goal -", "my wish is", "my wish is that", "could you make it so that",
    "make it so that", "make it so", "i 'd love to have", "i would love to have", "let it be that",
    "make", "show", "build me", "make me", "give", "i want to get", "i want you to have", "i want to find", "see",
    "we see", "i see", "you see", "there goes", "what i want is", "what we want is", "all i want is",
    "i want to see", "i would like to see", "i want", "i would like", "i would like to have", "i need", "we want",
    "we need", "show me", "make sure that", "make sure", "ensure that", "ensure", "see to it that",
    "give me", "please ensure", "let", "in the end", "at the end", "in the final state", "the goal is",
    "the goal is that", "the goal is to have", "the final state is", "the final state should be",
    "the result should be",
    "the result is", "i expect", "i want to have", "the final arrangement should be", "the desired state is",
    "the target is", "the final configuration is", "have", "get", "finally", "it should be that",
    "i want there to be", "the goal state is",
    "it should end with", "it ends with", "it must end with", "it has to end with", "the table shows",
    "the table should show", "the goal state has", "the end state is",
    "the final picture should show", "the final scene should show", "the final picture shows", "it is required that",
    "it should look like", "can i have", "can i get", "could i have", "could i get", "may i have",
    "i would love to see", "can i see", "could i see",
    "the final result should be", "in the final arrangement", "in the final configuration", "in the goal",
    "when you are done", "when you are done ,", "when finished", "by the end", "by the end ,",
    "when you are finished", "in the final state ,", "in the final arrangement ,", "finish with", "end with",
    "end up with",
    "the end result should be", "the final layout should be", "the final scene has", "the final scene should have",
    "the outcome should be", "the desired result is", "in the final picture", "in the final picture ,", "picture",
    "imagine", "i am looking for", "we are looking for", "the goal is for", "i want to end up with",
    "we should end up with", "you should end up with", "it must be that", "check that", "i need to see",
    "we want to see", "i like to see", "let there be", "the task is done when", "the task is complete when",
    "the task succeeds when", "done when", "success means", "success means that", "success when",
    "the goal is reached when",
)  # fmt: skip
START_FRAMES = Phrases(
    "starting with", "start with", "starting from", "initially", "given", "given that", "assume", "assume that",
    "assuming", "assuming that", "suppose", "suppose that", "at the start", "at the beginning", "in the beginning",
    "to begin with", "beginning with", "the initial state is", "in the initial state", "originally", "currently",
    "right now", "starting state", "start state", "start from", "the task starts with", "the scene starts with",
    "at first", "the episode starts with", "the initial state has", "as a start", "we start with",
    "start :", "start state :", "begin :", "begins :", "starts :", "start situation :",
    "at the start :", "in the beginning :", "initially :", "beginning :",
    "initial situation :", "starting position :", "before :", "you start with",
    "the scene begins with", "the start is", "starts with", "start out with", "begin with", "initial state :",
    "initially ,", "at the start ,",
    "at the beginning ,", "assume initially", "the starting state is", "the starting state has",
    "in the starting state", "the starting configuration is", "the initial configuration is", "beginning from",
    "at the beginning of the episode", "at the start of the episode", "at the start of the task",
    "at the beginning of the task", "at the start of the game", "let us say", "let us assume", "let us suppose",
    "it starts with", "everything starts with", "things start with", "it all starts with", "we begin with",
    "it begins with", "everything begins with", "initial :", "initial state is", "the starting point is", "at present",
    "at the moment", "given :", "currently :",
    "from a start with", "from a state where", "starting from a state where",
)  # fmt: skip
FIRST = Phrases(
    *(
        f"{lead}{many} {steps} :"
        for lead in ("", "in ", "do it in ", "the ")
        for many in ("two", "three", "four", "2", "3", "4")
        for steps in ("steps", "stages", "phases", "moves", "parts", "actions")
    ),
    *(
        f"as {the} first {step}{end}"
        for the in ("the", "a", "your", "our")
        for step in ("step", "stage", "thing", "action", "move")
        for end in ("", " ,", " :")
    ),
    "in this order :", "in the following order :", "in this order ,", "in the following order ,", "this is the order :",
    "the order is :", "the order of events :", "the order of events is :",
    "start by", "begin by", "phase 1 :", "stage 1 :", "phase one :", "stage one :",
    "step 1 :", "step 2 :", "step 3 :", "step 4 :", "step 4", "step one :", "step two :",
    "first things first", "first things first :", "first things first ,", "to start ,", "to start with ,",
    "to begin ,", "first :", "1 :", "2 :", "3 :", "picture this", "like this", "as follows", "put it all like this",
    "put everything like this",
    "arrange it like this", "do this", "do the following", "it goes like this", "arrange everything like this",
    "make it so that", "make it so",
    "first", "firstly", "to begin", "second", "secondly", "third", "thirdly", "step one", "step two", "step three",
    "step 1", "step 2", "step 3", "first of all", "at first", "first ,",
)  # fmt: skip
DONT = (
    "do not", "never", "avoid", "do n't", "not", "you are not allowed to", "you are not permitted to",
    "you are not supposed to", "it is not allowed to", "it is not permitted to", "it is forbidden to",
    "it is prohibited to", "nobody may", "no one may", "the robot is not allowed to", "the arm is not allowed to",
    "the robot must not", "the arm must not", "the robot may not", "the robot should not", "you are forbidden to",
)  # fmt: skip
"""What is said behind these must not be done."""
THEN = (
    "continue with", "continue by", "second of all",
    "and only then", "only then", "and only afterwards", "only afterwards", "but only then", "and only later",
    "and not before that", "and only after that", "only after that", "and at last", "at last",
    "and at the very end",
    "and finish by", "finish by", "and end by", "end by", "and conclude by", "conclude by", "and finish off by",
    "and then after that", "and then finally", "and after that", "and afterwards", "and finally", "and then",
    "then finally", "then after that", "after that", "afterwards", "after which", "thereafter", "followed by",
    "and next", "and lastly", "next", "finally", "lastly", "then", "subsequently", "before finally",
    "once that is done", "and subsequently", "after this", "when that is done", "once done", "once this is done",
    "when done",
)  # fmt: skip
TAG = Phrases(
    "please", "thanks", "thank you", "if you can", "if possible", "for me", "if you could", "thank you very much",
    "ok", "okay", "either", "would you", "will you", "can you", "could you", "now", "as well", "too",
    "on your own", "if you please", "thanks a lot", "in the end", "at the end", "when you are done",
    "once finished", "when finished", "at the end of the task", "in the final state",
)  # fmt: skip
