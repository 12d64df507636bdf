"""What words mean in MuJoCo: scene, predicates, visibility, initial states, goal arrangement."""
