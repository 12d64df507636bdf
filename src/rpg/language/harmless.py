"""Everyday words that can tell nothing of blocks: no arrangement, look, number, size, shape, place, contact, order,
movement or turn. What is said in them around a task is left out, with a note; see `remarks`.

Kept by what may be said with them. Words that could be meant of blocks in some sentence ("tidy", "alone", "home",
"clean", "straight", "gently", "stay") are in none of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from rpg.language.grammar.talk.people import PEOPLE as FOLK
from rpg.language.word_lists import listed

_PEOPLE = f"""
    {FOLK.replace("|", " ")}
    man woman boy girl lady gentleman baby toddler twin parent grandparent stepmother stepfather nan nana papa mama
    aunty godmother godfather bride groom bridesmaid spouse fiance fiancee widow orphan stranger person somebody someone
    everybody everyone anybody folk crowd guest visitor host hostess neighbour tenant landlord landlady lodger
    lawyer judge policeman policewoman officer soldier sailor pilot driver captain firefighter fireman postman plumber
    electrician carpenter builder mason painter baker butcher cook cleaner farmer gardener fisherman hunter shepherd
    waiter waitress barman bartender cashier clerk secretary accountant banker broker merchant shopkeeper seller
    salesman buyer dentist surgeon vet pharmacist midwife therapist psychologist patient scientist researcher engineer
    programmer developer designer tester inspector auditor operator technician mechanic architect physicist chemist
    biologist mathematician historian philosopher economist journalist reporter editor author writer poet novelist
    musician singer drummer pianist violinist guitarist dancer actor actress comedian magician clown juggler acrobat
    photographer filmmaker director producer artist sculptor critic reader listener spectator fan player champion
    athlete runner swimmer referee trainee apprentice intern newcomer beginner novice amateur expert professional
    specialist perfectionist pensioner retiree volunteer assistant helper robots adviser consultant chairman president
    minister mayor king queen prince princess knight wizard witch fairy santa priest nun monk pastor bishop rabbi imam
    headmaster headmistress principal tutor lecturer docent librarian janitor caretaker babysitter nanny cousin
    hero heroine genius angel devil boss chief crew staff committee jury sweetheart sweetie darling honey
    dear buddy chap fella lad lass dude bro sis grader freshman sophomore schoolboy schoolgirl preschooler spy reviewer
"""
"""Who somebody is."""
_ANIMALS = """
    dog cat puppy kitten hamster rabbit bunny guinea mouse rat bird parrot budgie canary chicken hen rooster duck goose
    pony horse donkey cow calf sheep lamb goat pig piglet fish goldfish turtle tortoise frog spider bee ant butterfly
    hedgehog squirrel fox wolf bear lion tiger elephant giraffe monkey ape penguin owl pet beast animal dinosaur dragon
    unicorn teddy doll puppet
"""
_OCCASIONS = """
    party birthday wedding anniversary funeral christening baptism christmas easter halloween thanksgiving carnival
    hanukkah ramadan eid diwali holiday vacation trip journey picnic barbecue festival fair concert opera theatre
    theater play ballet cinema movie film documentary commercial advert trailer tutorial video clip photo photograph
    snapshot selfie camera newspaper magazine blog website newsletter brochure poster postcard story
    fairytale tale legend riddle quiz puzzle game bet contest competition tournament championship match race prize
    award medal challenge mission assignment exercise homework lesson class school kindergarten nursery college
    university campus course lecture seminar workshop training practice rehearsal exam examination test experiment study
    thesis dissertation paper report essay article book chapter textbook manual presentation talk speech demo
    demonstration show performance exhibition museum gallery library lab laboratory office meeting appointment deadline
    interview job career duty task project plan hobby pastime habit tradition custom ritual ceremony surprise
    present gift treat favour favor reward welcome farewell goodbye visit visitor guest breakfast brunch lunch dinner
    supper tea coffee snack meal bedtime playtime break nap sleep bath weekend weekday monday tuesday wednesday thursday
    friday saturday sunday january february march april june july august september october november december spring
    summer autumn winter season morning afternoon evening night tonight midnight today tomorrow yesterday day week
    noon lunchtime dinnertime afternoon
    month year century moment minute hour while time times future past childhood youth life world memory dream wish hope
    idea thought opinion reason cause sake fun pleasure joy delight happiness luck fortune love friendship peace quiet
    patience courage pride honour honor respect trust faith mood humour humor laughter smile tears sorrow grief pity
    shame regret worry fear panic stress trouble bother problem difficulty crisis emergency accident disaster mess chaos
    nightmare headache illness fever cold flu health weather rain snow sun storm traffic noise music song dance art
    science math maths physics chemistry biology history geography english french german latin religion politics
    economics business money budget salary rent tax news gossip secret mystery curiosity knowledge wisdom experience
    skill talent progress success effort hurry rush worries apology apologies excuse thanks regards greetings request
    question answer call message note memo reminder email mail chat conversation discussion argument quarrel experts
    brainteaser audition therapy rehab research evaluation benchmark assessment occasion event
    childhood example exhibit customer handwriting sense deal kind thing things stuff bit lot
    everything something way rule protocol warning gymnastics
"""
"""What happens, when, and what is thought of."""
_THINGS = """
    house flat apartment kitchen bedroom bathroom garden yard balcony garage cellar attic shop supermarket bakery
    restaurant cafe pub bar hotel hospital church temple mosque bank airport harbour harbor playground zoo
    farm village town city country beach sea ocean lake river forest mountain car bus bike bicycle train plane boat
    van lorry phone telephone mobile laptop computer tablet television radio fridge oven kettle toaster teapot mug
    cup glass bottle spoon fork knife plate bowl pan pot sofa couch armchair chair bed pillow blanket curtain lamp
    candle vase pen pencil crayon marker eraser notebook
    flower bouquet tree bush umbrella coat jacket hat scarf glove shoe boot sock shirt
    dress skirt trousers jeans apron purse wallet bag suitcase backpack key watch necklace glasses toy balloon
    kite cake cookie biscuit bread butter cheese ham sausage egg milk juice water beer wine soup salad pizza pasta rice
    potato tomato onion carrot apple pear banana cherry strawberry lemon grape sweets candy chocolate sugar
    salt pepper honey porridge pancake knee shoulder
    tooth tummy stomach brain heart hair quilt dishes laundry piano guitar violin drum
"""
"""What one has and sees about oneself. Tasks have none of it: nobody can be asked for it, or to put anything on it."""
_VERBS = """
    admire adore agree amuse annoy apologise apologize applaud appreciate argue arrive ask astonish babysit bake beg
    behave believe bet blame bless boast bother breathe brag calm care celebrate chat check cheer chew clap comfort
    commute complain concentrate congratulate convince cook cough count crave cry cuddle dance dare decide demand
    deserve
    desire dictate die digest dine disappoint discuss dread dream drink drive earn eat embarrass
    encourage enjoy entertain envy excite exercise expect explain faint fancy fear feed feel fidget fight film
    flirt forget forgive gamble garden giggle gossip graduate greet grieve grin groan grumble guess happen hate hear
    hesitate hope hum hurry hurt imagine impress inspire insist invite judge knit know laugh learn
    lecture listen live love marry matter meditate mind moan mourn nag nap notice obey offend owe panic pay
    persuade photograph play please practise practice praise pray prefer prepare promise quarrel quiz rain
    realise realize recognise recognize recommend record recover rehearse relax rely remember remind
    report request respect retire reward rush save say scold scream sew shoot shop shout shrug sigh sing sleep smell
    smile smoke sneeze snore snow sob speak squabble stress study suffer suppose surprise suspect swear sweat swim
    talk taste tease teach tell tempt thank think travel tremble trust try understand vacuum visit vote wait wake
    want warn watch wave weep whisper whistle win wink wish wonder work worry wrestle yawn yell yodel
    demonstrate like need have get come go call take make do give show help buy sell
"""
_IRREGULAR = """
    arose ate eaten became began bet bought came caught cost did done drank drunk drove driven felt found forgot
    forgotten forgave fought gave given went gone got had heard hurt knew known lost made meant met paid said
    sold sang slept spoke spoken spent stolen swam taught told took thought understood woke won
    wept wore
    bitten dreamt learnt heard married tried cried worried hurried studied makes does goes has
"""
_PERSONAL = """
    tired sleepy hungry thirsty ill sick well unwell injured sore dizzy drunk busy bored lazy late early ready awake
    asleep retired unemployed pregnant married divorced engaged widowed young elderly nervous anxious
    worried afraid scared frightened terrified shocked stressed exhausted upset annoyed angry mad furious grumpy
    moody sulky jealous lonely homesick sad unhappy disappointed depressed miserable happy glad pleased delighted
    thrilled cheerful merry proud excited curious keen eager impatient patient polite rude shy bold brave fussy picky
    strict particular pedantic forgetful clumsy blind deaf grateful thankful
    obliged indebted sorry ashamed embarrassed guilty confused puzzled amazed astonished surprised impressed amused
    fond interested sure certain confident convinced serious honest sincere loyal faithful generous stingy rich poor
    famous popular clever smart intelligent stupid silly foolish mad crazy insane talented gifted skilled
    experienced inexperienced creative artistic musical sporty ambitious optimistic pessimistic superstitious religious
    vegetarian vegan allergic addicted desperate hopeless helpless
    visiting retired serious able willing unable
"""
"""How people are."""
_FINE = """
    nice good great lovely wonderful perfect cool awesome amazing fantastic brilliant excellent superb marvellous
    marvelous terrific fabulous splendid delightful charming adorable cute pretty beautiful gorgeous sweet fun funny
    hilarious amusing entertaining enjoyable pleasant exciting thrilling interesting fascinating intriguing boring dull
    tedious annoying irritating sad pathetic terrible awful horrible dreadful ghastly ridiculous absurd weird strange
    odd bizarre unusual ordinary everyday typical classic classical traditional famous popular fashionable trendy
    modern simple easy difficult hard tricky tough challenging demanding doable feasible possible important
    essential crucial vital urgent useful useless helpful handy practical relevant
    serious silly stupid clever smart wise sensible reasonable fair unfair kind friendly generous polite welcome
    special favorite favourite best better worst worse magic magical mysterious secret private personal official
    professional educational scientific artistic romantic festive solemn peaceful relaxing soothing calming stressful
    true real obvious understood okay ok alright fine super ideal appreciated trivial elegant tasty
    worth legendary epic dreamy priceless unbelievable incredible
"""
"""What is thought of a task, or of how it came out; nothing that could be seen of blocks but that somebody likes it."""
_ADVERBS = """
    honestly frankly seriously luckily sadly fortunately unfortunately ideally obviously normally usually naturally
    certainly definitely absolutely probably hopefully apparently evidently clearly surely truly really very so too
    quite rather pretty awfully terribly extremely incredibly super totally completely utterly simply just only also
    even still
    already always often sometimes rarely seldom ever once soon later lately recently nowadays again now then today
    tonight tomorrow yesterday currently presently meanwhile eventually finally suddenly actually basically essentially
    literally personally secretly officially privately desperately badly dearly deeply highly hugely particularly
    especially mainly mostly anyway anyhow somehow indeed perhaps maybe please kindly thankfully sincerely cordially
    warmly happily gladly proudly here online abroad
"""
_INTERJECTIONS = """
    ha haha hahaha hehe hooray hurray yay wow oops gosh phew alas ahoy bravo cheers ciao adios hello hi hey hiya howdy
    greetings bye goodbye thanks thank ta thx welcome amen bingo voila bonjour hola aloha congrats congratulations
    sorry pardon please okay ok alright yes yeah yep sure lol omg oh ah aha well hmm ugh ouch yikes hallelujah
    tyvm tysm thxx kthx kthxbye thnx tks tnx plzz plss thankyou cheerio toodles
    ooh oo aw aww yippee tada hurrah um uh er erm hm mm yo jeez blimey crikey bruh dawg ngl imho tbh lmao rofl ayo
    gosh darn
"""
_NAMES = """
    tom tim jim john jack james peter paul max ben sam dan david daniel michael mike chris thomas george henry
    harry william bill bob robert richard joe joseph charles charlie oliver leo luke lucas noah liam emma olivia sophie
    sophia anna anne hannah sarah laura julia lisa lena lucy alice ella mia maria marie mary jane kate emily charlotte
    grace amy eva ida nina priya olga ivan omar ali ahmed fatima yusuf hiro yuki chen wei juan carlos pedro diego luis
    sofia carmen pierre luca giulia marco hans fritz ingrid lars sven norway sweden france germany spain italy england
    britain ireland scotland wales america canada mexico brazil india china japan korea australia europe africa asia
    london paris berlin rome madrid
"""


_CALLS = re.compile(r"o+h*|a+h+|w+h?o+(?:a+h*)?|w+h+e{2,}|e{2,}k+|h+m{2,}|m{2,}h*|u+h+|(?:ha){2,}h?|(?:he){2,}|"
                    r"y+a{2,}y+|y+e{2,}s+|w+o+w{2,}|w+o{2,}h*o+|t+a+d+a{2,}|hooray+|ps{2,}t+|shh+|brr+|hell+o{2,}|"
                    r"hi{2,}|he+y{2,}|ple+a+se{2,}|pleas{2,}e|so{3,}|uff+|pff+|(?:hi){2,}|(?:ho){2,}|oi+|aye+|ahem|"
                    r"yipp(?:ee|ie)+|alrighty|righto|okie|dokie|okey|dokey|oopsie|whoops|yup+|yep+|yum+y?|bam|boom|"
                    r"hurray|e+r{2,}")  # fmt: skip
"""Calls as they are drawn out."""


def exclaimed(word: str) -> bool:
    """Whether a word is a call: "ooh", "yaaay"."""
    return word in INTERJECTIONS or _CALLS.fullmatch(word) is not None


def _nouns(text: str) -> frozenset[str]:
    """The words with their plurals."""
    return frozenset(form for word in text.split() for form in (word, _with_s(word)))


def _with_s(word: str) -> str:
    if word.endswith("y") and word[-2] not in "aeiou":
        return f"{word[:-1]}ies"
    return f"{word}es" if word.endswith(("s", "x", "z", "ch", "sh")) else f"{word}s"


def _inflected(word: str) -> Iterator[str]:
    """A verb's regular forms."""
    yield _with_s(word)
    if word.endswith("ie"):
        stem, past = f"{word[:-2]}y", f"{word}d"
    elif word.endswith("e"):
        stem, past = (word if word.endswith("ee") else word[:-1]), f"{word}d"
    elif word.endswith("y") and word[-2] not in "aeiou":
        stem, past = word, f"{word[:-1]}ied"
    elif word[-1] in "bdgmnprt" and word[-2] in "aeiou" and (len(word) < 3 or word[-3] not in "aeiou"):
        yield f"{word}ing"
        yield f"{word}ed"
        stem, past = f"{word}{word[-1]}", f"{word}{word[-1]}ed"
    else:
        stem, past = word, f"{word}ed"
    yield f"{stem}ing"
    yield past


TIMES = _nouns("minute hour day week month year time night second century moment while")
PEOPLE = _nouns(_PEOPLE) | listed("men women children grandchildren people folks kids wives")
ANIMALS = _nouns(_ANIMALS) | listed("mice geese wolves")
OCCASIONS = _nouns(_OCCASIONS)
THINGS = _nouns(_THINGS)
VERBS = listed(_VERBS)
"""In the form of a command."""
DOINGS = VERBS | listed(_IRREGULAR) | {form for verb in VERBS for form in _inflected(verb)}
PERSONAL, FINE, ADVERBS, INTERJECTIONS, NAMES = map(listed, (_PERSONAL, _FINE, _ADVERBS, _INTERJECTIONS, _NAMES))
EVERYDAY = (PEOPLE | ANIMALS | OCCASIONS | THINGS | DOINGS | PERSONAL | FINE | ADVERBS | INTERJECTIONS) - listed(
    "favour favours favourite favourites"
)
"""All of them but names, and what has another spelling: words of their own, and no slips for others."""
