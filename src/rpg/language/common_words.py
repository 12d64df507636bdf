"""The words that are most said of blocks."""

_TEXT = """
    the and red of on blue blocks block green one in to two white three put yellow left is cubes with cube row
    right tower it from black be patch at top pink are table gray each four that there orange stack make bottom
    purple mat brown them all cyan cm five build must by should up other not order so between middle but front
    its colour ones end which letters shall then behind letter towers as six both goes out next has you place
    half spell first no grid into line please far start digits near move down exactly least or where have square
    every rows form an group side take high onto another same arrange eight word apart back off they may touch
    leave sort corner column like go starts any pyramid stacked want stand for stands than lie can lay upside
    only either touching me above plus equation columns read without color set turn numbers heap odd wall write
    gap number directly nothing long rainbow own away ends even vowels neither get goal base cat robot groups
    placed small made somewhere around alphabetical see wide big consonants none swap second empty reds separate
    rest digit centre after beside more lies checkerboard single before staircase together per seven whose keep
    shape would could patches bricks layer do alternating circle round reverse going starting use except
    distractors others outline we my moving below steps pile stays this corners everything alternate bring most
    sits let zone smallest stay nine brick belongs blues just lying way about initially reading nor over reads
    equals stacks time standing also moved need mm target using correct show places evenly their upright sign
    when else lowest boxes never while height spaced beginning belong being largest ascending under center last
    immediately within biggest now distractor flat box distance ten triangle centres lower equal filled matter
    what picture colors clear gaps final hi upper descending very navy closer different leftmost third if foot
    built spot layers nearest edge carries little straight begin arranged sit touches lime again gets rectangle
    true position such upon degrees unstack finally grey teal alphabetically does too whole tall pls carry along
    mats possible latter until hello these afterwards sitting those centimetres inside step task push highest
    was plain laid clockwise seen formed crimson anything spelled stairs rotate bunch anywhere state twelve well
    finish hollow given rests symmetric been comes done towards respectively times pick here heights greens
    trade violet stranger area minus gold sides shows ok sorted piles mirrored large equally whichever viewer
    mirror once itself gather how look turned kindly readable mind add sure rightmost gradient begins located
    farthest exchange care sum name turquoise
"""
COMMON_WORDS = {word: place for place, word in enumerate(_TEXT.split())}
"""Their places, from the most common one on."""
