"""Ordinary words that mean nothing here, and are no misspelling of the word of the language that they are near."""

_TEXT = """
    absorbed actress addiction admiral adoption advocate advocates age aid alignment alleged ally altered alternatively
    alternatives ambition ambitious amusing angled annually apologize apparent appeals arena army arrival artistic
    ashamed aspects asses assessed assured ate attacked attending attracted auction audition aviation awaiting awake
    bait bald ban band banking banning bark basic basics bat bay beaches bean beast beating beats bend bet biased bin
    bite blaming blow blowing bluish bone booking boom booth born borough bought bout bowling branches branding breaking
    brighter brownish browser bubbles buddies budget bug bugs bullying bun buns bus bush butcher cafe cage calling
    calories camp cane cape capitol carve casting catalogue categories caution cautious cease centuries certainty
    channels charged charges charging charter chase cheaper cheated cheating checking cheering chick chickens chicks
    chile chin chopped chronic circulation citation claimed clarify cleaning closet clothing clutter coalition coast
    coat coke cold collective collector collectors colonel colorado com commons compact company compared compares
    comparing compelling competing competitive competitor compilation compound compromise conceived concept concepts
    concerning concerts conduct confession confusing connect connection connections conquer conquest consent consistent
    constant consult consulting consumed consumer continent continuing contour control contracted contracts contrary
    convicted conviction convince cook cop core correlation correspondent corrupt corruption cos costa county courage
    crashes crate crates cream creators creature creatures credited crowded cure curse curtain cut cuts cutting cycling
    dancing dangling darker dawn dealt deciding decisive deck declaration decline declined decorative dedicated
    dedication defects defended defending deficit definitive del deleted delicate demanding demons demonstrating den
    density departed dependent depressing descent deserved designation destined destruction detached detection dies
    difficulty digging dioxide directory dismissed disputed distribution district districts dividend doc dome dong doses
    dotted doubles drafted dragons dressing drivers driving drone earning ears east eden edition education eighteenth
    elected element eleventh eligible emerge emerged emerging employee enacted endure engaged entering entries evident
    evolution examine excellence exclude execute exit expanding expecting experts expired exploded exploit explored
    exports expressing factions fade failing failure failures fame fare farm farmers farming fast fastest fear fed
    feeding feeling fees fellows fiction fifteenth fig fight fighting filing filters finale firm firms fishing flag
    flavor flew float flood floods flour flowers flowing fluffy folders font forcing forever forge formats forum forums
    founding fours fourteenth fraction freight friction fried fuller funded funding funds fur gain gas gentleman glowing
    goat golf granite grass greener grind grinding guts habitat hail halt handing handy happier hardy harmful hats
    haunted headed headline heal hearings heart heat heaviest heavily heir herb heritage hip hips hire hiring historic
    hit hits hood hoop host hosted hosting hosts hue hues hug hunt hunting ignorant imagery imaging impression inc
    incline induced inferior inherent insects insider insight insisted inspire instance instructor interact interim
    internal internet intersect intro invented invested investing investor investors invited isle jumping kicking knit
    knowing lamb lane lanes lap late laughed laughing launch lawyer lawyers lazy leaders leagues lean learnt leather led
    lego leisure lent lettering lettuce liberal liberals lick lighter lighting limiting liner linking listing listings
    literary litigation lively liver locking logs loser losers lover lucky lung lungs machinery magical maid maker
    makers male males mandate manipulation mankind mansion mapping marched marching marines market markets marking
    married marsh mary massage mast masters maternal maths matrices maturity meat melt men merger metal mighty mild min
    minority missile moat moisture mold momentum monitor monument moore moss mountains movement mud multiples necessity
    needing nicer niche nineteenth node noise noon norm noting numerous nursing objection obsessed obtaining occurred
    occurring offence offense offering officer opposing opposites opposition organisms ounce overlap overlay pace
    packaging palace paler palm pants parenting participant participants passion passive pasta paste patents pave paying
    payments peel peer pension peru pet petty photography phrase phrases pie pier pierce pig pill pills pine ping pipe
    pipes pitched pitcher plaid planet planets plank planks pole poles poll polling popped popping portion portions
    portrait portraits positive possess posting practical pray praying predict premier premise preservation preserve
    preserved president presidents pressing pressure pretend pretending prevent prevented preventing prevents princess
    probable processor profession profile progress promote promoted prompted prop property prophet proposal prospect
    prospective prospects protect province provision publish punch punished purse pursued pursuing qualify quantity
    quietly raining raise raising rally ran ranking rare ratings reaching react reaction reality realm receipt receiver
    recession referring refined reflect regarding regulate regulation rejected relaxed relaxing release released
    releases releasing reliable reliance relieve relieved remarks repairs repeated replied replies reporting residents
    resolve restored resumed retained retaining retirement retiring retreat reunion rev revealed revealing revelation
    revenge revenue revenues revised rewarded rid rider ridge riding rig rodgers root roots rope rounder rugby ruin
    ruins ruler rung sad safer sake salt san sand sands savings scatter scent scoring screaming screams sea seas sec
    secondary sections seeds seek seeking seize seized selection selective sell selling sells sentence sentences sept
    serious servant server setback sevens seventeenth sew shades shadows shake shallow shelf shelter shirts shock
    shooter shopping shore shores shout shouting shuttle sick sigh signals simpler sims sincere sing sixteenth ski
    slanted sleepy slice slices slider smashed smiling snack snapped snow soap soft solids song spam sparse spatial
    spawn specialty specified spend spending spends spent spirits spit spoiled sporting spotted springs stall star
    staring starring stars starving statue statues statute steady steam steep sticky stir stitched stole stopped strange
    streaming streams striker string strings striped stroke stronger struck structural studies succession successor
    suitable suite sun sunrise superb superior supervision supportive surf surge surgery surveys survive swamp sweat
    sweater sweeping swinging tablet tablets tag tags tangent tapered tapping tech teen tempted tens tent terrace
    terraces testify theater theatre thereby thirds thirteenth thorough threaded threat threw tiger tigers tile tin tint
    tissues toes tolerate toll tories tory tough tracking tragedy trained trainer trans transverse treated treaty tree
    tribal tribes trips trough trucks tuned turrets twitter unclear undergo unicorn unified unity unlocked unstable
    unusually uploaded useless variant vent vicious victoria violent viral virtual visa voice volumes waist walks
    wandering war warming warn wars wash washing weather wedding weddings wet wheat whoa william windows wing wings wise
    witch wondered wore workplace worlds worm worms worn worried worrying worship wounded writer wrote yellowish
    youngest
"""
OTHER_WORDS = frozenset(_TEXT.split())
"""A hue is not huge, and no contour a colour: such a word is said to be unknown."""
