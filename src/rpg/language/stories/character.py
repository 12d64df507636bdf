"""Words of character, mood and grace: "brave", "grumpy", "elegant" tell no colour, size, shape, number or place of a
block, and no block from another one."""

from __future__ import annotations

from rpg.language import harmless
from rpg.language.word_lists import listed

_OF_PEOPLE_ALONE = listed("""
    able allergic asleep awake blind certain confused crazy deaf divorced dizzy drunk early elderly engaged ill
    injured insane interested late lonely mad married musical particular poor pregnant ready religious retired rich
    sick sore sporty stressed strict sure unable unemployed unwell upset vegan vegetarian visiting well widowed
    willing young
""")
"""How people are, of which nobody speaks ahead of a block, or which could be said of how it lies."""
_MOODS = listed("""
    bashful cheery contented coy cranky dreamy drowsy envious fearful giggly gleeful gloomy greedy
    grouchy hopeful inquisitive jolly joyful joyous lonesome lovesick melancholic mournful nosy playful relaxed
    satisfied startled sullen timid weary
""")
_CHARACTERS = listed("""
    adorable alert arrogant attentive bewitched bossy calm carefree careless charming chatty cheeky chic
    courageous cowardly cuddly cunning cute daring dignified diligent eccentric enchanted energetic enigmatic
    evil fearless feisty ferocious fierce friendly funny gallant gentle goofy grim hardworking haughty heroic
    humble innocent invincible likeable lively lovable lucky magical mighty mischievous modest mysterious
    nasty naughty noble noisy peaceful powerful quiet quirky restless selfish serene silent sly sneaky snobbish
    stealthy stubborn sweet talkative tame trustworthy trusty unlucky vain valiant venerable vigilant watchful
    wicked wild wise witty
""")
_GRACES = listed("""
    beautiful breathtaking captivating classy comfy cosy cozy dapper dashing dazzling delightful divine dramatic
    dreamlike elegant enchanting epic ethereal exquisite fabled flamboyant glamorous gleaming glistening
    glittering glorious glossy gorgeous graceful gracious handsome heavenly iconic inviting kingly lavish
    legendary lovely luxurious mythical opulent ornate picturesque polished posh precious pretty priceless
    princely quaint queenly radiant refined regal resplendent rustic shimmering shiny showy slender slim
    sophisticated sparkling sparkly splendid stately striking stunning stylish sublime sumptuous swanky tasteful
    timeless welcoming whimsical
""")
"""What somebody thinks who looks at it."""
TELLING_NOTHING = (harmless.PERSONAL - _OF_PEOPLE_ALONE) | _MOODS | _CHARACTERS | _GRACES


def manner(word: str) -> bool:
    """Whether a word tells no more than in what mood something is done: "proudly", "happily"."""
    stem = word[:-2]
    return word.endswith("ly") and (stem in TELLING_NOTHING or f"{stem[:-1]}y" in TELLING_NOTHING)
