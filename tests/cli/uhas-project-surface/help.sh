uhas-project-surface --help
