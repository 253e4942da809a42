"""Commands on environments: information, studios and skies, lights, prefiltering."""
