"""Makes the bundled example: its textures, its meshes and its recording. Standard library only."""
