"""Phrases that leave open what is open anyway: "in any order", "whichever you like", "it does not matter where"."""

FREE = (
    *(
        f"{lead}{which} order{free}"
        for lead in ("", "in ")
        for which in ("any", "whatever", "whichever")
        for free in ("", " you like", " you want", " you please", " you prefer", " you wish", " you choose",
                     " suits you", " at all", " is fine with me", " you fancy", " will do", " is fine", " works",
                     " i do not mind")
    ),
    "the order does not matter", "order does not matter", "no matter the order",
    *(f"{the} order{of} {free}"
      for the in ("the", "their", "its")
      for of in ("", " of the rows", " of the columns", " of the layers", " of the colors",
                 *(f" {inside} {each} {whole}" for inside in ("inside", "within", "in") for each in ("the", "each", "a")
                   for whole in ("stack", "tower", "row", "line", "column", "pile", "group")))
      for free in ("does not matter", "is up to you", "is free", "is your choice", "is irrelevant", "is open",
                   "is not important", "is unimportant", "is of no importance", "is not relevant")),
    *(f"{lead} the order" for lead in ("i do not care about", "do not care about", "never mind", "ignore")),
    *(f"{it}does not matter {which} order" for it in ("it ", "") for which in ("in which", "in what", "which", "what")),
    *(f"{the}order of the {others} {free}"
      for the in ("the ", "") for others in ("other two", "others", "rest", "other ones", "other three")
      for free in ("open", "is open", "does not matter", "is up to you", "is free")),
    "its direction does not matter", "any orientation", "in any orientation",
    "no particular order", "in no particular order", "whichever way", "whichever way you like",
    "any way you like", "however you like", "whichever direction", "in whichever direction",
    "direction does not matter", "the direction does not matter", "in no particular direction",
    "regardless of the order", "regardless of order", "the exact order does not matter", "in random order",
    "in a random order", "hello", "hi", "hello there", "hi there", "hello robot", "hi robot", "hey", "hey robot",
    "hello everyone", "good morning", "good day", "dear robot", "ok", "okay", "alright", "great", "your choice",
    "up to you", "as you like", "you choose", "either is fine",
    "whichever", "whatever", "your pick", "you pick", "take your pick", "your call", "you decide", "you can decide",
    "whatever is easier", "whichever is easier", "whatever is easiest", "go", "easy one first", "next level", "today",
    "i do not care which of the others is on top", "please do one thing", "not even a bit", "not one bit",
    "that will do", "that will do fine", "that will be fine", "that would do", "either will do", "either one will do",
    "i could not care less", "i could not care less which", "either side will do", "either way will do",
    *(f"{lead}{both}{free}" for lead in ("", "and ") for both in ("both count", "either counts", "either one counts")
      for free in ("", " as success", " as a success", " as done", " as solved", " as right", " as correct")),
    *(f"{both} {free}"
      for both in ("both is", "both are", "either is", "either side is", "either way is", "either one is")
      for free in ("acceptable", "fine", "ok", "okay", "all right", "alright", "good", "possible", "allowed")),
    *(f"{lead} {which}"
      for lead in ("it does not matter", "does not matter", "no matter", "i do not care", "do not care",
                   "i do not mind")
      for which in ("which", "which one", "which ones", "where", "which side", "on which side", "how", "how exactly")),
    "distance does not matter", "the distance does not matter", "at whatever distance", "no matter how far",
    "any color", "any colors", "of any color", "whatever color", "whatever colors", "the color does not matter",
    "color does not matter", "colors do not matter", "the colors do not matter", "any color will do",
    "any color is fine", "i do not care", "do not care", "i do not mind", "rather", "whichever you prefer",
    "whatever you prefer", "whichever you like", "whatever you like",
    "the side does not matter", "on whichever side", "whichever side", "in either order", "either order is fine",
    "which goes where is up to you", "which one goes where is up to you", "which is which does not matter",
    "which goes where does not matter", "it does not matter which goes where", "in both cases", "in either case",
    "in any case", "however", "which ones does not matter", "which ones is up to you",
    "which ones you choose is up to you", "which ones you like", "whichever one",
    *(
        f"{lead} {which} {hue}{have}"
        for lead in ("it does not matter", "no matter", "i do not care", "i do not mind", "does not matter",
                     "do not care", "do not mind", "not fussed")
        for which in ("which", "what")
        for hue in ("color", "colors")
        for have in ("", " they have", " they are", " you use", " you take", " it has", " it is")
    ),
    *(f"{lead} {which} {blocks}{use}"
      for lead in ("it does not matter", "does not matter", "no matter", "i do not care", "do not care",
                   "i do not mind")
      for which in ("which", "what")
      for blocks in ("blocks", "cubes", "ones")
      for use in ("", " you use", " you take")),
    *(f"{lead} {hues}"
      for lead in ("i do not care about", "do not care about", "never mind", "no matter", "i do not mind")
      for hues in ("colors", "the colors", "the color")),
    "colors random", "color random",
    "any corner", "whichever corner", "which corner does not matter", "no matter which corner",
    "not necessarily directly", "not necessarily next to it", "not necessarily adjacent",
    "that is all", "that is it", "i think", "nothing else matters", "nothing else really matters",
    "all good", "otherwise it does not count", "otherwise it is not done", "otherwise you fail",
    *(
        f"{lead}{which} {hue}{free}"
        for lead in ("", "in ", "of ", "with ", "using ")
        for which in ("any", "whatever", "whichever", "arbitrary", "random")
        for hue in ("color", "colors")
        for free in ("", " you like", " you want", " you have", " you please", " you prefer", " is fine", " are fine",
                     " will do", " there are", " at all", " will be fine", " is ok")
    ),
    *(f"{mind}{which}"
      for mind in ("it is all the same to me", "it is all the same to us", "all the same to me", "it is all one to me",
                   "it makes no difference", "makes no difference", "it makes no difference to me",
                   "makes no difference to me", "i am not fussed", "i really do not care", "i do not really care",
                   "i really do not mind", "i am indifferent", "we are indifferent", "i have no preference",
                   "we have no preference", "no preference", "i am easy", "i am not fussy", "not fussy")
      for which in ("", " which", " which one", " which of them", " which of the two", " as to which",
                    " as to which one", " as to which of them", " about which", " about which one", " about that")),
    *(f"{which} {free}"
      for which in ("which", "which one", "which of them", "which of the two", "which of these")
      for free in ("is immaterial", "is irrelevant", "is unimportant", "is of no importance", "is not important",
                   "is up to you", "is your choice", "is left to you", "does not matter", "makes no difference")),
    *(f"{either} {suits}"
      for either in ("either", "either one", "either of them", "either way")
      for suits in ("suits me", "will suit me", "works", "works for me", "pleases me", "is fine with me",
                    "is fine by me", "is good for me", "is all right with me")),
    "i leave it to you", "i leave that to you", "i will leave that to you", "i leave the choice to you",
    "i leave it up to you", "i leave which to you", "that is up to you", "the choice is yours",
    *(f"{lead}{choice}" for lead in ("with the ", "with ", "the ", "") for choice in (
        "colors however you like", "color however you like", "colors as you like", "colors of your choice",
        "colors up to you", "color up to you", "color of your choice", "colors are up to you", "color is up to you")),
)  # fmt: skip
"""What leaves open what is open anyway, beside a comma or at an end of the sentence."""
ANY_OF_THEM = tuple(
    f"{which} {blocks}{free}"
    for which in ("any", "whichever", "whatever", "just any", "any old", "random")
    for blocks in ("blocks", "cubes", "bricks", "ones")
    for free in ("", " you like", " you want", " will do", " are fine", " do")
)
"""Behind so many blocks, at the end of their sentence, that it may be any."""
FOREIGN = (
    "grazie", "grazie mille", "merci", "merci beaucoup", "merci bien", "danke", "danke schon", "vielen dank",
    "bitte", "gracias", "muchas gracias", "por favor", "obrigado", "obrigada", "muito obrigado", "per favore",
    "prego", "s'il vous plait", "s il vous plait", "sil vous plait", "arigato", "dank je", "dank je wel",
    "alstublieft", "takk", "tak", "kiitos", "spasibo", "efharisto", "shukran", "dziekuje", "ciao", "hola",
    "bonjour", "hallo", "namaste", "guten tag", "buenos dias", "salut", "servus", "ta very much",
)  # fmt: skip
"""Greetings and thanks of those who speak other languages as well."""
LOOSE = tuple(
    f"{lead}{what}{free}"
    for what in ("which way round", "which way it points", "how far", "how far away", "how far away it is",
                 "how far away they are", "how far it is", "the distance", "the exact place",
                 "where exactly", "where on the table")
    for lead, free in (("it does not matter ", ""), ("does not matter ", ""), ("no matter ", ""),
                       ("", " does not matter"), ("", " is up to you"),
                       *((f"{who} do not {mind} ", "") for who in ("i", "we") for mind in ("mind", "care")))
)  # fmt: skip
"""The same of places and ways round: what is told of a line or of a distance would not be so open."""
