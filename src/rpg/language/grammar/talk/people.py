"""Who speaks, looks on and works, and what of: words that all talk around an instruction shares."""

from __future__ import annotations

from rpg.language.phrases import Classes

PEOPLE = (
    "customer|customers|client|clients|boss|user|users|teacher|friend|friends|daughter|son|student|students|pupil|"
    "pupils|class|kid|kids|child|children|little_ones|little_one|team|colleague|colleagues|mother|father|mom|dad|wife|"
    "husband|grandmother|grandfather|grandma|grandpa|niece|nephew|brother|sister|sponsor|reviewer|reviewers|professor|"
    "audience|visitors|guests|public|viewers|family|mum|mummy|mommy|daddy|granny|grandad|granddad|grandson|"
    "granddaughter|uncle|aunt|auntie|cousin|flatmate|roommate|girlfriend|boyfriend|partner|buddy|mate|pal|manager|"
    "supervisor|advisor|adviser|mentor|lecturer|tutor|examiner|foreman|coach|trainer|trainee|trainees|"
    "apprentice|intern|candidate|participant|participants|neighbor|doctor|"
    "nurse|chef"
)
"""Whom an instruction may be for."""
RELATIONS = (
    "mum|mom|mummy|mommy|mama|dad|daddy|papa|mother|father|grandma|grandpa|granny|grandad|granddad|grandmother|"
    "grandfather|auntie|uncle"
)
"""Those of them who are named without "my"."""
SEVERAL = "visitors|guests|customers|clients|users|viewers|children|kids|pupils|students|friends"
"""Those of them who are named without an article."""
FINE = (
    "great|nice|good|lovely|wonderful|perfect|cool|awesome|amazing|fantastic|super|brilliant|kind|helpful|appreciated|"
    "very_kind|much_appreciated|the_best|fine|fun|enough|neat|ideal|excellent"
)
"""What is said of good work."""
EVENTS = (
    "demo|demonstration|test|experiment|game|exercise|show|presentation|puzzle|video|photo|picture|figure|paper|lesson|"
    "class|course|lecture|school|homework|exam|project|birthday|party|story|story_time|workshop|practice|training|task|"
    "session|fun|photograph|poster|slide|slides|thesis|report|website|scenario|trial|benchmark|evaluation|study|episode"
)
"""What an instruction may be given for."""
AGENTS = (
    "you", "we", "the robot", "our robot", "this robot", "the child", "the student", "the user", "somebody",
    "someone", "the arm", "the agent",
    "the robot arm", "the machine", "the player", "the kid", "the pupil", "the worker", "the operator", "your robot",
    "the children", "the kids", "the students", "people", "the person", "the gripper", "the manipulator", "i", "he",
    "she", "a robot", "a person", "a child", "a kid", "a student", "a player", "a worker", "a user", "an operator",
    "a pupil",
    "the trainee", "the apprentice", "the intern", "the candidate", "the participant", "a robot arm", "an arm",
    "an agent", "one robot", "the human", "a human",
)  # fmt: skip
"""Who does something in the indicative: "the robot puts ..." asks for it."""
WORKERS = frozenset({"robot", "arm", "agent", "gripper", "machine", "player", "worker", "operator", "manipulator",
                      "child", "kid", "student", "pupil", "person", "human", "he", "she"})  # fmt: skip
"""Of whom it may go on without a subject: "the robot takes the red block and puts it on ..."."""
DOERS = ("somebody", "someone", "the robot", "the robot arm", "the arm", "the machine", "they", "people", "a child",
          "the child", "the children", "the kids", "the gripper", "some child")  # fmt: skip
"""Who has done something: what is told of it is so then."""
TITLES = (
    "captain", "skipper", "professor", "doctor", "doc", "nurse", "coach", "sergeant", "officer", "chef", "chief",
    "boss", "comrade", "darling", "honey", "sweetie", "dear", "my dear", "love", "my love", "your honor",
    "your highness", "your majesty", "my lord", "milady", "maestro", "champ", "bud", "partner", "colleague", "sunshine",
)  # fmt: skip
"""Whom it is said to, where a comma sets them off."""
WHO = {
    "which": (
        "the|my|our|your|this|that|a|an|one|some|every|their|his|her",
        f"the|my|our|your robot|camera|viewer|{PEOPLE} 's",
    ),
    "folk": (f"little|young|younger|older|big|dear? {PEOPLE}",),
    "onlooker": ("<folk>", "little|young? viewer|camera|observer|robot|beholder|onlooker|spectator|spectators"),
    "who": ("i|we|you|he|she|they", "<which> <folk>", RELATIONS, SEVERAL),
    "person": (
        "i|we|you|one|people|somebody|someone|anybody|anyone|everybody|everyone|they",
        "<which> <onlooker>",
    ),
    "viewer": ("<which>? <onlooker>",),
    "robot": ("the|your|our|this? robot|robot_arm|arm|agent|machine|gripper|manipulator",),
}
"""Classes of them."""
WISHING = Classes(
    {
        **WHO,
        "would": ("would|will|should|'d|do|may|might|can|could|must|am|are|is|was|were",),
        "also": ("have_always|always|just|also|simply|now|like|here|still",),
        "want": (
            "fancy|asked|be_delighted|be_thankful|be_thrilled|want|wants|wanted|like|likes|love|loves|need|needs|"
            "prefer",
            "prefers|wish|wishes|hope|hopes|ask|asks|require|requires|expect|expects|imagine|imagines|request|requests",
            "have_in_mind|picture|propose|suggest|envision|look|looking|hoping|asking|wondering|wanting|dreaming|"
            "aim|aims|aiming|strive|strives|striving|go|going",
            "appreciate|welcome|vote|settle|opt|demand|demands|desire|desires|be_satisfied|be_content",
            "imagining|picturing|envisioning|visualizing|visualising|thinking|appreciate_it|be_happy|be_glad|be_pleased|be_grateful|wishing",
        ),
        "see": (
            "to_see|to_have|to_get|to_find|to_end_up_with|to_be_shown|seeing|having|for|with|that|it_if|if|of|"
            "there_to_be",
            "it_that|me_for|us_for|you_for|:",
        ),
        "do": (
            "to|you_to|you_could|you_would|you_can|you_might|the_robot_to|the_arm_to|us_to|me_to|to_ask_you_to",
            "it_if_you_would|it_if_you_could|if_you_could|if_you_would|it_if_you|that_you|if_you|when_you",
            "you_if_you_could|you_if_you_can|me_if_you_could|us_if_you_could",
        ),
        "picture": (
            "picture|image|photo|photograph|drawing|sketch|figure|scene|view|arrangement|result|layout|setup|state",
        ),
    }
)
"""What is wished, and how."""
