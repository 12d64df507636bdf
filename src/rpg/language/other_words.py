"""Ordinary words that mean nothing here, and are no misspelling of the word of the language that they are near."""

_TEXT = """
    absorbed actress addiction admiral adoption adverse advocate advocates age aid aides alignment alleged ally
    altered alternative alternatively alternatives ambition ambitious amusing angled annually apologize apparent
    appeals arena aria army arrests arrival ars artistic ashamed aspects asses assessed assured asymmetric ate
    attacked attending attracted auction audition aviation awaiting awake bae bait bald ban band banking banning
    bark barking barrage barriers barring bas basic basics bass bat bay beaches bean beast beating beats beck
    bedding belonged bench bend bending berries bet beverly biased billed bin bing bite blacked blaming blast
    blazers bloated blocked blocker blow blower blowing bluish blunder bog bone bones booking boom booth born
    borough bought bout bowling braking branches branding breaking breasts breeding brewing brig brighter brownie
    brownish browser bubbles buck buddies budget bug bugs buildup bullying bun buns burning burying bus bush busting
    butcher cafe cage calling calories cam camp cane cant cape capitol carr carrick carrier carve casting catalogue
    catcher categories causing caution cautious cease centric centrist centuries certainty channels charged charges
    charging charter chase cheap cheaper cheated cheater cheating checking cheering chester chick chickens chicks
    chile chilled chin chopped chronic circled circulation citation claimed clan clarify cleaning closet closure
    clothing clutter coaching coalition coast coat coke cold collars collective collector collectors colonel
    colorado com commons compact company compared compares comparing compelling competing competitive competitor
    compilation compound compromise conceived concept concepts concerning concerts conduct confession confusing
    connect connection connections conquer conquest consent consistent constant consult consulting consumed consumer
    continent continuing contour contracted contracts contrary control convicted conviction convince cook cop core
    cornered corrected correlation correspondent corrupt corruption cos costa county courage courier cracked crashes
    crate crates cream creators creature creatures credited crest crowded cubs cure curry curse curtain cut cuts
    cutting cycling dancing dangling darker dawn dealing dealt deciding decisive deck declaration decline declined
    decorative dedicated dedication defects defended defending deficit definitive deformed del deleted delicate
    demanding demons demonstrating den density departed dependent depressing deranged descent deserved designation
    destined destruction detached detection dies difficulty digging digital dignity dioxide directory dismissed
    disputed distracted distribution district districts diverse dividend doc dolores dome donated dong doses dotted
    doubles dover drafted dragons dressing drilled drivers driving drone earnest earning ears east eden edgy edition
    education eighteenth elected element eleventh eligible emerge emerged emerging emitting employee enacted endure
    engaged entering entries estate estates evident evolution examine excellence exclude execute exit expanding
    expecting experts expired exploded exploit explored exports exposition expressing fable factions fade failing
    failure failures fame fare farm farmers farming fast fastest fat fear fed feeding feeling fees fellows fiction
    fifteenth fig fight fighting filing filters finale finisher fir firm firms fishing fixture flag flavor flew
    float floated flock flood floods flour flowers flowing fluffy flying folders font forcing forever forge formats
    fort forum forums founding fours fourteenth fraction freaking freight friction fried frown fuller funded funding
    funds fur gain gas gentleman glowing goat golf grad grading granite grass greener grilled grind grinding guild
    guilt guts habitat hail halt handing handy happier hardy harmful hatched hats haunted headed headline heal
    healing hearings heart heat heather heating heavenly heaviest heavily heir herb heritage himself hip hips hire
    hiring historic hit hits hitters hoe hood hoop hornets host hosted hosting hosts housing hue hues hug hunt
    hunting ignorant imagery imaging imposition impression inc incline incorrect indirectly induced inferior
    informed inherent input insects insider insight insisted inspire instance instructor interact interim internal
    internet intersect intro invented invested investing investor investors invited islands isle jumping kicking
    knit knowing laced lag lamb lame lane lanes lantern lap largely las lat latch late laughed laughing launch
    lawyer lawyers lazy leach leaders leagues leaking lean leaping learnt leasing leather led ledge legions lego
    leisure lending lent lest lettering lettuce liberal liberals lice lick lied lighter lighting lim limiting limo
    liner ling linking listing listings lit lite literary litigation lively liver loathing locking locks loft logs
    loser losers lottery lover lucky lung lungs machinery magical maid maker makers male males mandate manipulation
    mankind mansion mao mapping marched marching mare marines market markets marking married mars marsh mary massage
    mast masters maternal maths matrices maturity meat melt men menus merger metal mighty mild min minority miracle
    missile mist moat moisture mold molding momentum monitor monument moore mos moss mountains movement mover mud
    multiples nat nearing necessity needing nest netting nicer niche nineteenth nod nodding node noise non noon norm
    notable noting nuclear numerous nursing objection obsessed obtaining occurred occurring offence offense offering
    officer ominous opposing opposites opposition organisms ounce outright overlap overlay pace paced packaging pain
    palace paler palm pants parenting participant participants passion passive pasta paste patents pave payers
    paying payments peach peck pee peel peer pending pension perk peru perverse pet petition petty photography
    phrase phrases pie pier pierce pig pill pills pine ping pipe pipes pitched pitcher placebo plagued plaid planet
    planets plank planks plaster platter pleading poaching pole poles poll polling popped popping portion portions
    portrait portraits positive possess posting posture practical pray praying predict premier premise preservation
    preserve preserved president presidents pressing pressure pretend pretending prevent prevented preventing
    prevents princess probable probate processor profession profile progress promote promoted prompted prop property
    prophet proposal prospect prospective prospects prostate protect province proving provision publish punch
    punished punk punt purse pursued pursuing qualify quantity quietly radiant raining raise raising rally ran range
    ranking rare ratings reaching react reaction readily reality realm receipt receiver recession referring refined
    reflect regarding regulate regulation rejected relaxed relaxing release released releases releasing reliable
    reliance relieve relieved remarks remorse repairs repeated replied replies reporting resided residents
    residing resolve resorted resorts restored resumed retained retaining retirement retiring retreat reunion rev
    revealed revealing revelation revenge revenue revenues revised rewarded rewrite rid rider ridge riding rig
    rioting road roads roaming roaring rodgers root roots rope ros rounder routine rover rugby ruin ruins ruler rung
    sad safer sake salt san sand sands savings sax scatter scent scented scoring screaming screams screens sea seas
    seaside sec secondary sections seed seeds seek seeking seize seized selection selective sell selling sells
    sentence sentences sept sequels serious servant server ses setback settler sevens seventeenth sew sexually
    shades shading shadows shake shallow sharpen sharper shay shelf shell shelter shirts shock shooter shopping
    shore shores shout shouting showers shuttle sibling sick sigh sight signals signing simpler sims sincere sing
    sire sixteenth skating ski skit slanted slayer slaying sleepy slice slices slider slime slit slower slumber
    smashed smiling snack snapped snow soap soft solids song sounding spam sparked sparse spatial spawn specialty
    specified spend spending spends spent spirits spit spitting spoiled sporting spotted springs squared squire
    stabbing staffed staffing stag stained stall stalled stalling stamped stamping star stare staring starring stars
    starters starving stats statue statues statute steady steal steam steep sterling stevens stewards sticky stir
    stitched stole stopped strains strange streaming streams strides striker string strings striped stroke stronger
    struck structural studies stunning succession successor suitable suite sun sunrise superb superior supervision
    supportive surf surge surgery surveys survive swamp sweat sweater sweeping swinging sword tablet tablets tag
    tags tangent tanning tapered tapping targeted tech teen tempted tending tends tens tent terrace terraces testify
    theater theatre thereby thigh thirds thirteenth thorough threaded threat threw thunder tiger tigers tile timbers
    tin tint tissues toes tolerate toll tones tories torrent tory tough tougher touring tracked tracking trader
    tragedy trained trainer trans transverse treated treaty tree tribal tribes trips trough trucks tue tuned turrets
    twitter unclear undergo unicorn unified unity unlocked unstable unusually uploaded upstairs upstate useless uss
    variant vent venture ventures vicious victoria violate violent viral virtual visa voice volumes voucher vouchers
    wade waist walks wandering war warming warn warranted wars wash washing wat wearable wearing weather wedding
    weddings weights welding wet whale wheat wherein whoa whore wight william windows wing wings wis wise wit witch
    wondered wore workplace worlds worm worms worn worried worrying worship wounded wright writer wrote yellowish
    yorkers youngest zoned
"""
OTHER_WORDS = frozenset(_TEXT.split())
"""A hue is not huge, and no contour a colour: such a word is said to be unknown."""
