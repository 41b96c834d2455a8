uhas-project-surface
